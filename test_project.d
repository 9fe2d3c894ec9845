test_project.o: tests/test_project.c tests/cmocka_ready.h \
  firmware/project.h firmware/blend.h firmware/config.h firmware/clip.h \
  firmware/view.h firmware/perspective.h firmware/fixed.h \
  firmware/profile.h firmware/rows.h firmware/camera.h firmware/errors.h \
  firmware/transform.h firmware/scene.h firmware/cull.h firmware/rect.h \
  firmware/fill.h firmware/target.h firmware/measure.h firmware/edge.h \
  firmware/samples.h firmware/span.h firmware/stats.h tests/random.h

tests/cmocka_ready.h:

firmware/project.h:

firmware/blend.h:

firmware/config.h:

firmware/clip.h:

firmware/view.h:

firmware/perspective.h:

firmware/fixed.h:

firmware/profile.h:

firmware/rows.h:

firmware/camera.h:

firmware/errors.h:

firmware/transform.h:

firmware/scene.h:

firmware/cull.h:

firmware/rect.h:

firmware/fill.h:

firmware/target.h:

firmware/measure.h:

firmware/edge.h:

firmware/samples.h:

firmware/span.h:

firmware/stats.h:

tests/random.h:
