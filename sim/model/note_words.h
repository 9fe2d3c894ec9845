/* SPDX-License-Identifier: MIT
 *
 * What several readers say of what they leave out or draw otherwise, and what `limner formats` says of it beforehand
 * (formats/read_table.h): each once. They stand behind a number or a name. */
#ifndef SIM_NOTE_WORDS_H
#define SIM_NOTE_WORDS_H

#define WORDS_MEAN_COLOURS "faces have colours that change over them; each is drawn in their mean"
#define WORDS_REPEATS "faces reach beyond a picture that is not to repeat; it repeats"
#define WORDS_WHOLE_PICTURES "materials move, turn or scale their pictures, which is not done"
#define WORDS_Z_UP "z is up, as in most files of that kind; --up y, if not"
#define WORDS_SKINS "meshes have a skeleton (skin): they are drawn as they were modelled, not posed"
#define WORDS_MORPHS "meshes are drawn without their morph targets, whose weights change their shape"
#define WORDS_LIGHTS "its lights are not drawn; faces are lit by a lamp of the renderer's own"
#define WORDS_SHINE "shine is not drawn"
#define WORDS_LINES "lines and points are not drawn, only faces are"
#define WORDS_LISTS_OF_LINES "lists of points or lines are not drawn; faces are"
#define WORDS_BEAMS "objects have beams, which are not drawn"
#define WORDS_CURVES "curves and surfaces are not drawn: save them as polygons"
#define WORDS_NO_FACES "there are no faces in it"
#define WORDS_NO_MORPHS "it has meshes with morph targets, which the importer does not read: export it without"
#define WORDS_NO_FILE "there is no such file"
#define WORDS_WITHOUT "; --no-textures does without"
#define WORDS_NOT_IN_IT "is not in it: drawn without it"
#define WORDS_GREY "grey instead"
#define WORDS_OFF_OF_BYTES "OFF of bytes is not read; save it as text"
#define WORDS_UDMF "is of UDMF, which is not read"

#endif
