golden_state_fast.o: tests/golden_state_fast.c tests/golden_state_of.h \
  tests/golden_state.h tests/golden_stage.h sim/camera_path.h \
  sim/compiled.h sim/core.h firmware/limner.h firmware/camera.h \
  firmware/config.h firmware/errors.h firmware/instance.h \
  firmware/scene.h firmware/lamp.h firmware/motion.h firmware/stats.h \
  firmware/target.h firmware/rect.h firmware/state.h firmware/convex.h \
  firmware/project.h firmware/blend.h firmware/clip.h firmware/view.h \
  firmware/perspective.h firmware/fixed.h firmware/profile.h \
  firmware/rows.h firmware/transform.h firmware/cull.h firmware/fill.h \
  firmware/measure.h firmware/edge.h firmware/samples.h firmware/span.h \
  firmware/texture.h firmware/delta.h firmware/rects.h firmware/runs.h \
  firmware/eye.h firmware/movers.h firmware/sorted.h firmware/newell.h \
  firmware/paint.h firmware/active.h firmware/retain.h firmware/layers.h \
  firmware/smooth.h firmware/mask.h firmware/wire.h firmware/walk.h \
  firmware/portals.h sim/error.h sim/mesh.h sim/map.h sim/model.h \
  sim/texture.h sim/method.h sim/tree_kind.h sim/plane.h \
  sim/point_blocks.h sim/moving.h sim/simulator.h sim/image.h \
  sim/panel_board.h sim/emulated_display.h sim/display.h hal/panels.h \
  hal/dcs.h hal/panel.h hal/pixels.h hal/bus.h hal/wire.h hal/pages.h \
  hal/sharp.h hal/solomon.h hal/port.h sim/emulated_dcs.h \
  sim/emulated_port.h sim/emulated_pages.h sim/emulated_sharp.h \
  sim/emulated_solomon.h boards/common/screen.h hal/greys.h

tests/golden_state_of.h:

tests/golden_state.h:

tests/golden_stage.h:

sim/camera_path.h:

sim/compiled.h:

sim/core.h:

firmware/limner.h:

firmware/camera.h:

firmware/config.h:

firmware/errors.h:

firmware/instance.h:

firmware/scene.h:

firmware/lamp.h:

firmware/motion.h:

firmware/stats.h:

firmware/target.h:

firmware/rect.h:

firmware/state.h:

firmware/convex.h:

firmware/project.h:

firmware/blend.h:

firmware/clip.h:

firmware/view.h:

firmware/perspective.h:

firmware/fixed.h:

firmware/profile.h:

firmware/rows.h:

firmware/transform.h:

firmware/cull.h:

firmware/fill.h:

firmware/measure.h:

firmware/edge.h:

firmware/samples.h:

firmware/span.h:

firmware/texture.h:

firmware/delta.h:

firmware/rects.h:

firmware/runs.h:

firmware/eye.h:

firmware/movers.h:

firmware/sorted.h:

firmware/newell.h:

firmware/paint.h:

firmware/active.h:

firmware/retain.h:

firmware/layers.h:

firmware/smooth.h:

firmware/mask.h:

firmware/wire.h:

firmware/walk.h:

firmware/portals.h:

sim/error.h:

sim/mesh.h:

sim/map.h:

sim/model.h:

sim/texture.h:

sim/method.h:

sim/tree_kind.h:

sim/plane.h:

sim/point_blocks.h:

sim/moving.h:

sim/simulator.h:

sim/image.h:

sim/panel_board.h:

sim/emulated_display.h:

sim/display.h:

hal/panels.h:

hal/dcs.h:

hal/panel.h:

hal/pixels.h:

hal/bus.h:

hal/wire.h:

hal/pages.h:

hal/sharp.h:

hal/solomon.h:

hal/port.h:

sim/emulated_dcs.h:

sim/emulated_port.h:

sim/emulated_pages.h:

sim/emulated_sharp.h:

sim/emulated_solomon.h:

boards/common/screen.h:

hal/greys.h:
