/* SPDX-License-Identifier: MIT
 *
 * What is called of lib3mf 1.8, whose own header is C++ though its functions are C's. Each returns 0 if it could do
 * what it is for. Handles are released once; identifiers are those of the file's resources. */
#ifndef SIM_LIB3MF_H
#define SIM_LIB3MF_H

#include <stdint.h>

typedef void *lib3mf_handle;

enum { LIB3MF_MICROMETRE, LIB3MF_MILLIMETRE, LIB3MF_CENTIMETRE, LIB3MF_INCH, LIB3MF_FOOT, LIB3MF_METRE };
enum { LIB3MF_OTHER, LIB3MF_MODEL, LIB3MF_SUPPORT, LIB3MF_SOLID_SUPPORT, LIB3MF_SURFACE };
enum { LIB3MF_NOTHING, LIB3MF_BASE_MATERIAL, LIB3MF_COLOUR, LIB3MF_PLACE, LIB3MF_COMPOSITE };
enum { LIB3MF_WRAP, LIB3MF_MIRROR, LIB3MF_CLAMP, LIB3MF_ONCE };

/* Of three corners. */
struct lib3mf_places {
    uint32_t picture;
    float u[3], v[3];
};

/* Of a reader, what went wrong; the text is its own. */
int32_t lib3mf_getlasterror(lib3mf_handle, uint32_t *code, const char **text);
int32_t lib3mf_release(lib3mf_handle);

int32_t lib3mf_createmodel(lib3mf_handle *model);
int32_t lib3mf_model_queryreader(lib3mf_handle model, const char *format, lib3mf_handle *reader);
int32_t lib3mf_reader_readfrombuffer(lib3mf_handle reader, uint8_t *bytes, unsigned long long size_b);
int32_t lib3mf_reader_getwarningcount(lib3mf_handle reader, uint32_t *count);
int32_t lib3mf_reader_getwarningutf8(lib3mf_handle reader, uint32_t index, uint32_t *code, char *text, uint32_t size_b,
                                     uint32_t *needed_b);
int32_t lib3mf_model_getunit(lib3mf_handle model, uint32_t *unit);
int32_t lib3mf_model_getbuilditems(lib3mf_handle model, lib3mf_handle *items);
int32_t lib3mf_model_getbasematerialbyid(lib3mf_handle model, uint32_t id, lib3mf_handle *materials);
int32_t lib3mf_model_gettexture2dbyid(lib3mf_handle model, uint32_t id, lib3mf_handle *picture);

int32_t lib3mf_builditemiterator_movenext(lib3mf_handle items, int *is_there);
int32_t lib3mf_builditemiterator_getcurrent(lib3mf_handle items, lib3mf_handle *item);
int32_t lib3mf_builditem_getobjectresource(lib3mf_handle item, lib3mf_handle *object);
int32_t lib3mf_builditem_getobjecttransform(lib3mf_handle item, float transform[3][4]);

int32_t lib3mf_resource_getresourceid(lib3mf_handle object, uint32_t *id);
int32_t lib3mf_object_gettype(lib3mf_handle object, uint32_t *type);
int32_t lib3mf_object_ismeshobject(lib3mf_handle object, int *is_mesh);
int32_t lib3mf_object_createdefaultpropertyhandler(lib3mf_handle object, lib3mf_handle *properties);
int32_t lib3mf_componentsobject_getcomponentcount(lib3mf_handle object, uint32_t *count);
int32_t lib3mf_componentsobject_getcomponent(lib3mf_handle object, uint32_t index, lib3mf_handle *component);
int32_t lib3mf_component_getobjectresource(lib3mf_handle component, lib3mf_handle *object);
int32_t lib3mf_component_gettransform(lib3mf_handle component, float transform[3][4]);

int32_t lib3mf_meshobject_getvertexcount(lib3mf_handle mesh, uint32_t *count);
int32_t lib3mf_meshobject_getvertices(lib3mf_handle mesh, float (*vertices)[3], uint32_t most, uint32_t *count);
int32_t lib3mf_meshobject_gettrianglecount(lib3mf_handle mesh, uint32_t *count);
int32_t lib3mf_meshobject_gettriangleindices(lib3mf_handle mesh, uint32_t (*corners)[3], uint32_t most,
                                             uint32_t *count);
int32_t lib3mf_meshobject_getbeamcount(lib3mf_handle mesh, uint32_t *count);
int32_t lib3mf_meshobject_getslicestackid(lib3mf_handle mesh, uint32_t *id);
int32_t lib3mf_meshobject_createpropertyhandler(lib3mf_handle mesh, lib3mf_handle *properties);

int32_t lib3mf_propertyhandler_getpropertytype(lib3mf_handle properties, uint32_t triangle, uint32_t *type);
int32_t lib3mf_propertyhandler_getbasematerial(lib3mf_handle properties, uint32_t triangle, uint32_t *materials,
                                               uint32_t *index);
int32_t lib3mf_propertyhandler_getcolor(lib3mf_handle properties, uint32_t triangle, uint8_t rgba[3][4]);
int32_t lib3mf_propertyhandler_gettexture(lib3mf_handle properties, uint32_t triangle, struct lib3mf_places *places);
int32_t lib3mf_defaultpropertyhandler_getpropertytype(lib3mf_handle properties, uint32_t *type);
int32_t lib3mf_defaultpropertyhandler_getbasematerial(lib3mf_handle properties, uint32_t *materials, uint32_t *index);
int32_t lib3mf_defaultpropertyhandler_getcolor(lib3mf_handle properties, uint32_t unused, uint8_t rgba[4]);
int32_t lib3mf_defaultpropertyhandler_gettexture(lib3mf_handle properties, uint32_t *picture, float *u, float *v);

int32_t lib3mf_basematerial_getdisplaycolor(lib3mf_handle materials, uint32_t index, uint8_t *red, uint8_t *green,
                                            uint8_t *blue, uint8_t *alpha);
int32_t lib3mf_texture2d_getpathutf8(lib3mf_handle picture, char *text, uint32_t size_b, uint32_t *needed_b);
int32_t lib3mf_texture2d_gettilestyleuv(lib3mf_handle picture, int *across, int *up);
int32_t lib3mf_texture2d_getattachment(lib3mf_handle picture, lib3mf_handle *file);
int32_t lib3mf_attachment_getstreamsize(lib3mf_handle file, unsigned long long *size_b);
int32_t lib3mf_attachment_writetobuffer(lib3mf_handle file, uint8_t *bytes, unsigned long long size_b);

#endif
