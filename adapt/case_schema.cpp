#include "adapt/case_schema.h"

namespace parmesan {
namespace {

// The one place that says which keys a case may have, of what type and range, and their defaults:
// the reader checks and completes cases by it. "title" is how errors name what is allowed.
constexpr const char* kSchema = R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Parmesan case",
  "type": "object",
  "required": ["geometry", "problem"],
  "patternProperties": { "^x-": {} },
  "additionalProperties": false,
  "properties": {
    "$schema": { "type": "string", "description": "for editors; not read" },
    "name": { "type": "string",
              "description": "names the output folder; default: the file's name, with _ for what is no letter or digit" },
    "title": { "type": "string", "default": "", "description": "shown in reports" },
    "parameters": {
      "type": "object", "default": {}, "additionalProperties": { "$ref": "#/$defs/parameter" },
      "description": "constants for expressions; one may use those before it"
    },
    "geometry": { "$ref": "#/$defs/geometry" },
    "problem": { "anyOf": [{ "$ref": "#/$defs/interpolation" }, { "$ref": "#/$defs/equation" }],
                 "description": "what the mesh is for: an equation to solve, or a function to interpolate" },
    "functionals": {
      "type": "object", "default": {}, "patternProperties": { "^x-": {} },
      "additionalProperties": { "$ref": "#/$defs/functional" },
      "description": "name -> a number made of the solution, reported with every iteration"
    },
    "solver": { "$ref": "#/$defs/solver", "default": {} },
    "metric": { "$ref": "#/$defs/metric", "default": {} },
    "targets": { "$ref": "#/$defs/targets", "default": {} },
    "mesher": { "$ref": "#/$defs/mesher", "default": {} },
    "initial": { "$ref": "#/$defs/initial", "default": {} },
    "output": { "$ref": "#/$defs/output", "default": {} },
    "expect": { "$ref": "#/$defs/expect", "default": {} }
  },
  "$defs": {
    "parameter": { "title": "a number or an expression of earlier parameters", "type": ["number", "string"] },
    "constant": { "title": "a number or an expression of the parameters", "type": ["number", "string"] },
    "scalar": { "title": "a number or an expression", "type": ["number", "string"] },
    "vector": { "title": "a list [a, b]", "type": "array", "items": { "$ref": "#/$defs/scalar" },
                "minItems": 2, "maxItems": 2 },
    "tensor": { "title": "a matrix [[a, b], [b, c]]", "type": "array", "items": { "$ref": "#/$defs/vector" },
                "minItems": 2, "maxItems": 2 },
    "scalar_or_tensor": { "anyOf": [{ "$ref": "#/$defs/scalar" }, { "$ref": "#/$defs/tensor" }] },
    "scalar_field": { "anyOf": [{ "$ref": "#/$defs/scalar" },
      { "title": "an object region -> value", "type": "object", "minProperties": 1,
        "additionalProperties": { "$ref": "#/$defs/scalar" } }] },
    "vector_field": { "anyOf": [{ "$ref": "#/$defs/vector" },
      { "title": "an object region -> value", "type": "object", "minProperties": 1,
        "additionalProperties": { "$ref": "#/$defs/vector" } }] },
    "tensor_field": { "anyOf": [{ "$ref": "#/$defs/scalar" }, { "$ref": "#/$defs/tensor" },
      { "title": "an object region -> value", "type": "object", "minProperties": 1,
        "additionalProperties": { "$ref": "#/$defs/scalar_or_tensor" } }] },
    "point": { "title": "a point [x, y]", "type": "array", "items": { "$ref": "#/$defs/constant" },
               "minItems": 2, "maxItems": 2 },
    "ring": { "title": "a list of at least 3 points", "type": "array", "items": { "$ref": "#/$defs/point" },
              "minItems": 3 },
    "box": {
      "description": "a rectangle along the axes",
      "type": "object", "required": ["min", "max"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": { "min": { "$ref": "#/$defs/point", "description": "its lower left corner" },
                      "max": { "$ref": "#/$defs/point", "description": "its upper right corner" } }
    },
    "disc": {
      "description": "a circle and what is inside",
      "type": "object", "required": ["radius"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0], "description": "its middle" },
        "radius": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "description": "its radius" },
        "points": { "type": "integer", "minimum": 3, "maximum": 1000000,
                    "description": "corners of a regular polygon that takes the place of the circle; default: the true circle" }
      }
    },
    "arc": {
      "description": "a part of a circle",
      "type": "object", "required": ["radius", "from", "to"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0], "description": "of the circle" },
        "radius": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "description": "of the circle" },
        "from": { "$ref": "#/$defs/constant", "description": "where it begins, in degrees against the x axis" },
        "to": { "$ref": "#/$defs/constant",
                "description": "where it ends, in degrees; below 'from': it runs clockwise" }
      }
    },
    "ellipse": {
      "description": "an ellipse, or a part of one",
      "type": "object", "required": ["axes"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0], "description": "its middle" },
        "axes": { "$ref": "#/$defs/positive_pair", "description": "half the length of each" },
        "rotation": { "$ref": "#/$defs/constant", "default": 0, "description": "of the first axis, degrees" },
        "from": { "$ref": "#/$defs/constant", "default": 0,
                  "description": "where it begins, in degrees of its parameter t: axes (cos t, sin t)" },
        "to": { "$ref": "#/$defs/constant", "default": 360,
                "description": "where it ends, in degrees; below 'from': it runs clockwise" }
      }
    },
    "whole_ellipse": {
      "description": "an ellipse and what is inside",
      "type": "object", "required": ["axes"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0], "description": "its middle" },
        "axes": { "$ref": "#/$defs/positive_pair", "description": "half the length of each" },
        "rotation": { "$ref": "#/$defs/constant", "default": 0, "description": "of the first axis, degrees" }
      }
    },
    "positive_pair": { "title": "two positive numbers [a, b]", "type": "array",
                       "items": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 }, "minItems": 2, "maxItems": 2 },
    "spline": {
      "description": "a B-spline, with weights a NURBS",
      "type": "object", "required": ["points"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" }, "description": "control points" },
        "degree": { "type": "integer", "minimum": 1, "maximum": 16, "default": 3, "description": "of its polynomials" },
        "knots": { "type": "array", "items": { "$ref": "#/$defs/constant" },
                   "description": "points + degree + 1 of them; default: clamped at both ends, evenly spaced" },
        "weights": { "type": "array", "items": { "$ref": "#/$defs/constant" },
                     "description": "one for each point; default: 1, a B-spline" }
      }
    },
    "through": {
      "type": "object", "required": ["points"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "description": "the cubic spline through points",
      "properties": {
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" }, "description": "in their order" },
        "closed": { "type": "boolean", "default": false,
                    "description": "true: smoothly back to the first point; else the ends are without curvature" }
      }
    },
    "parametric": {
      "description": "a curve (x(t), y(t))",
      "type": "object", "required": ["x", "y"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "x": { "$ref": "#/$defs/scalar", "description": "an expression of t" },
        "y": { "$ref": "#/$defs/scalar", "description": "an expression of t" },
        "from": { "$ref": "#/$defs/constant", "default": 0, "description": "the first t" },
        "to": { "$ref": "#/$defs/constant", "default": 1, "description": "the last t" }
      }
    },
    "piece": {
      "description": "a piece of a boundary; one of 'line' to 'parametric'",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["line"] }, { "required": ["arc"] }, { "required": ["ellipse"] },
                { "required": ["spline"] }, { "required": ["through"] }, { "required": ["parametric"] }],
      "properties": {
        "line": { "title": "a list of at least 2 points", "type": "array", "items": { "$ref": "#/$defs/point" },
                  "minItems": 2, "description": "straight from point to point" },
        "arc": { "$ref": "#/$defs/arc" }, "ellipse": { "$ref": "#/$defs/ellipse" },
        "spline": { "$ref": "#/$defs/spline" }, "through": { "$ref": "#/$defs/through" },
        "parametric": { "$ref": "#/$defs/parametric" },
        "label": { "type": "string", "minLength": 1,
                   "description": "name of this side; default: boundary, of a hole that of the hole" }
      }
    },
    "path": { "title": "a list of pieces, each from where the one before ends", "type": "array",
              "items": { "$ref": "#/$defs/piece" }, "minItems": 1 },
    "naca": {
      "description": "an airfoil in a channel",
      "type": "object", "required": ["code"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "code": { "type": "string", "description": "four digits, such as 0012 or 2412, or five, such as 23012" },
        "chord": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "default": 1,
                   "description": "from the leading to the trailing edge" },
        "angle": { "$ref": "#/$defs/constant", "minimum": -90, "maximum": 90, "default": 0,
                   "description": "angle of attack in degrees, nose up" },
        "position": { "$ref": "#/$defs/point", "default": [0, 0], "description": "of the leading edge" },
        "points": { "type": "integer", "minimum": 8, "maximum": 100000,
                    "description": "corners of a polygon that takes the place of the airfoil; default: the true curve" },
        "channel": { "$ref": "#/$defs/box",
                     "description": "the box around it; required, but for shapes of union, intersection and difference" }
      }
    },
    "hole": {
      "description": "a hole; one of 'polygon', 'disc', 'ellipse' and 'curves'",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["polygon"] }, { "required": ["disc"] }, { "required": ["ellipse"] },
                { "required": ["curves"] }],
      "properties": {
        "polygon": { "$ref": "#/$defs/ring", "description": "its corners" },
        "disc": { "$ref": "#/$defs/disc" },
        "ellipse": { "$ref": "#/$defs/whole_ellipse" },
        "curves": { "$ref": "#/$defs/path", "description": "pieces that close" },
        "label": { "type": "string", "minLength": 1, "description": "name of its sides; default: hole1, hole2, ..." }
      }
    },
    "segment": {
      "description": "an edge, a curve or a crack inside of the domain; one of 'from' to 'parametric'",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["from"] }, { "required": ["arc"] }, { "required": ["ellipse"] },
                { "required": ["spline"] }, { "required": ["through"] }, { "required": ["parametric"] }],
      "properties": {
        "from": { "$ref": "#/$defs/point", "description": "where it begins, if it is straight" },
        "to": { "$ref": "#/$defs/point", "description": "where it ends; needed with 'from'" },
        "arc": { "$ref": "#/$defs/arc" }, "ellipse": { "$ref": "#/$defs/ellipse" },
        "spline": { "$ref": "#/$defs/spline" }, "through": { "$ref": "#/$defs/through" },
        "parametric": { "$ref": "#/$defs/parametric" },
        "label": { "type": "string", "minLength": 1, "default": "inside",
                   "description": "its name; of a crack, that of its left side" },
        "label_right": { "type": "string", "minLength": 1,
                         "description": "makes it a crack: the name of its side to the right of its direction" },
        "required": { "type": "boolean", "description": "true: stays one edge of every mesh; for straight ones; default: false" }
      }
    },
    "shapes": { "title": "a list of at least 2 shapes", "type": "array", "items": { "$ref": "#/$defs/shape" },
                "minItems": 2 },
    "shape": {
      "description": "an outline, one of 'rectangle' to 'difference', with its holes",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["rectangle"] }, { "required": ["disc"] }, { "required": ["ellipse"] },
                { "required": ["polygon"] }, { "required": ["curves"] }, { "required": ["naca"] },
                { "required": ["file"] }, { "required": ["union"] }, { "required": ["intersection"] },
                { "required": ["difference"] }],
      "properties": {
        "rectangle": { "$ref": "#/$defs/box", "description": "sides: left, right, bottom, top" },
        "disc": { "$ref": "#/$defs/disc", "description": "side: circle" },
        "ellipse": { "$ref": "#/$defs/whole_ellipse", "description": "side: ellipse" },
        "polygon": { "$ref": "#/$defs/ring", "description": "its corners; sides: boundary, unless labels are given" },
        "curves": { "$ref": "#/$defs/path",
                    "description": "pieces that close; sides: boundary, unless pieces have labels" },
        "naca": { "$ref": "#/$defs/naca", "description": "sides: airfoil, left, right, bottom, top" },
        "file": { "type": "string", "minLength": 1,
                  "description": "a geometry or a mesh of any format that is read; beside or below the case file" },
        "union": { "$ref": "#/$defs/shapes", "description": "what is in any of them" },
        "intersection": { "$ref": "#/$defs/shapes", "description": "what is in all of them" },
        "difference": { "$ref": "#/$defs/shapes", "description": "what is in the first and in none of the others" },
        "labels": {
          "anyOf": [
            { "title": "a list with a name per side of the polygon", "type": "array",
              "items": { "type": "string", "minLength": 1 } },
            { "title": "an object side -> new name", "type": "object",
              "additionalProperties": { "type": "string", "minLength": 1 } }],
          "description": "other names for sides; one for each side of a polygon, or old name -> new name"
        },
        "holes": {
          "type": "array",
          "items": { "anyOf": [{ "$ref": "#/$defs/ring" }, { "$ref": "#/$defs/hole" }] },
          "description": "lists of corners, or objects; labels of their sides: hole1, hole2, ..., unless a label is given"
        }
      }
    },
    "geometry": {
      "description": "the domain: an outline, one of 'rectangle' to 'difference', with what is inside",
      "properties": {
        "regions": { "type": "object", "additionalProperties": { "$ref": "#/$defs/point" },
                     "description": "name -> a point in the region" },
        "merge_tolerance": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                             "description": "points nearer than this become one, and segments bend to points as near, with a warning" },
        "required": { "type": "array", "items": { "type": "string", "minLength": 1 },
                      "description": "regions whose triangles stay as the file, or the first mesh, has them" },
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" },
                    "description": "vertices of every mesh, inside of the domain" },
        "segments": { "type": "array", "items": { "$ref": "#/$defs/segment" },
                      "description": "edges, curves and cracks inside of the domain" }
      }
    },
    "interpolation": {
      "description": "a problem without an equation",
      "type": "object", "required": ["interpolate"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": { "interpolate": { "anyOf": [{ "$ref": "#/$defs/scalar" }, { "$ref": "#/$defs/given_field" }],
                                       "description": "the function to adapt to" } }
    },
    "given_field": {
      "title": "an object with the keys 'file' and 'mesh'", "type": "object", "required": ["file", "mesh"],
      "additionalProperties": false, "patternProperties": { "^x-": {} },
      "description": "the P1 function with the values of a file at the vertices of a mesh",
      "properties": {
        "file": { "type": "string", "minLength": 1,
                  "description": "beside or below the case file: .sol or .solb, such as the mesh.sol that a run leaves, or a .msh with fields; .vtu is not read" },
        "mesh": { "type": "string", "minLength": 1,
                  "description": "the mesh of these values; beside or below the case file" },
        "field": { "type": "string", "minLength": 1,
                   "description": "which one, where the file has several; those of .sol are called by its name, and a number: u_1, u_2" }
      }
    },
    "equation": {
      "description": "-div(diffusion grad u) + velocity.grad u + reaction u = source",
      "type": "object", "required": ["boundary"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "diffusion": { "$ref": "#/$defs/tensor_field", "default": 1,
                       "description": "K: a number, a symmetric matrix, or one for each region; positive" },
        "velocity": { "$ref": "#/$defs/vector_field", "default": [0, 0],
                      "description": "b: of the flow, in the form b.grad u" },
        "reaction": { "$ref": "#/$defs/scalar_field", "default": 0, "description": "c: factor of u" },
        "source": { "$ref": "#/$defs/scalar_field", "description": "f; default: derived from exact, else 0" },
        "point_sources": { "type": "array", "items": { "$ref": "#/$defs/point_source" },
                           "description": "not with the targets h1_error and linf_error: the solution is infinite there" },
        "exact": { "$ref": "#/$defs/scalar",
                   "description": "the exact solution, where known: errors are measured against it, and boundary data may use it: under neumann it is n.K grad u, as the value of robin n.K grad u + coefficient u" },
        "stabilize": { "type": "boolean", "default": true,
                       "description": "SUPG where the mesh Peclet number exceeds 1" },
        "discontinuity_capturing": { "type": "boolean", "default": false,
                                     "description": "diffusion across the flow where layers are not resolved; not with defect_correction" },
        "defect_correction": { "type": "boolean", "default": false,
                               "description": "corrects the values at the vertices, so that the solution is about as accurate as the interpolant of the exact one; not with a goal nor with discontinuity_capturing" },
        "boundary": { "type": "object", "minProperties": 1, "additionalProperties": { "$ref": "#/$defs/condition" },
                      "description": "side -> its condition, \"*\" for all other sides; inner segments take one by their name only" }
      }
    },
    "point_source": {
      "type": "object", "required": ["at", "strength"], "additionalProperties": false,
      "patternProperties": { "^x-": {} }, "description": "strength times the delta distribution, added to the source",
      "properties": { "at": { "$ref": "#/$defs/point", "description": "where it is" },
                      "strength": { "$ref": "#/$defs/constant", "description": "how much it discharges" } }
    },
    "functional": {
      "description": "a number made of the solution u: one of 'integral', 'boundary_integral', 'flux' and 'value'",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["integral"] }, { "required": ["boundary_integral"] }, { "required": ["flux"] },
                { "required": ["value"] }],
      "properties": {
        "integral": { "type": "string", "minLength": 1, "description": "of u over a region, \"*\" for the domain" },
        "boundary_integral": { "type": "string", "minLength": 1, "description": "of u over the sides of a label, \"*\" for the boundary and all cracks" },
        "flux": { "type": "string", "minLength": 1, "description": "integral of n.K grad u over the sides of a label" },
        "value": { "$ref": "#/$defs/point", "description": "u at a point" },
        "weight": { "$ref": "#/$defs/scalar",
                    "description": "a factor of u in an integral or a boundary integral; default: 1" },
        "exact": { "$ref": "#/$defs/constant", "description": "its value for the exact solution, where known" }
      }
    },
    "condition": {
      "description": "one of 'dirichlet', 'neumann' and 'robin'; K is the diffusion, n points out of the domain",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["dirichlet"] }, { "required": ["neumann"] }, { "required": ["robin"] }],
      "properties": {
        "dirichlet": { "$ref": "#/$defs/scalar", "description": "the value of u" },
        "neumann": { "$ref": "#/$defs/scalar", "description": "the value of n.K grad u" },
        "robin": { "$ref": "#/$defs/robin" }
      }
    },
    "robin": {
      "type": "object", "required": ["coefficient", "value"], "additionalProperties": false,
      "patternProperties": { "^x-": {} }, "description": "n.K grad u + coefficient u = value",
      "properties": { "coefficient": { "$ref": "#/$defs/scalar", "description": "factor of u" },
                      "value": { "$ref": "#/$defs/scalar", "description": "the right side" } }
    },
    "solver": {
      "description": "how linear systems are solved; what is automatic depends on the size and the kind of the matrix",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "method": { "enum": ["automatic", "ldlt", "lu", "cg", "bicgstab", "gmres"], "default": "automatic",
                    "description": "tried first; direct methods follow where it fails. 'cg' and 'ldlt' not with a velocity" },
        "preconditioner": { "enum": ["automatic", "jacobi", "ilut", "multigrid"], "default": "automatic",
                            "description": "of iterative methods; 'ilut' not with 'cg'" },
        "restart": { "type": "integer", "minimum": 1, "maximum": 1000, "default": 50,
                     "description": "vectors that 'gmres' keeps" }
      }
    },
    "metric": {
      "description": "how large triangles are to be, and of which shape",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "kind": { "enum": ["sign-aware", "loseille-alauzet"], "default": "sign-aware",
                  "description": "whether triangles are larger where det H < 0 (H: second derivatives), where the same size gives less error" },
        "norm": { "anyOf": [{ "type": "number", "minimum": 1 },
                            { "enum": ["inf"] }], "default": 2,
                  "description": "p of the Lp norm of the error to minimise; 'inf' for the largest error" },
        "recovery": { "enum": ["least-squares", "double-projection", "zienkiewicz-zhu", "polynomial-preserving", "exact"],
                      "description": "how second derivatives are recovered; 'exact' needs problem.exact; default: zienkiewicz-zhu for solutions, least-squares for given functions" },
        "interpolation": { "enum": ["log-euclidean", "linear"], "default": "log-euclidean",
                           "description": "of metrics between the vertices of the previous mesh; linear as in the thesis" },
        "h_min": { "$ref": "#/$defs/scalar", "minimum": 0, "default": 0,
                   "description": "smallest length of edges, may vary with x and y; 0: none" },
        "h_max": { "$ref": "#/$defs/scalar", "minimum": 0, "default": 0,
                   "description": "largest length of edges, may vary with x and y; 0: a quarter of the diagonal of the domain's box" },
        "max_aspect": { "anyOf": [{ "enum": ["automatic"] }, { "$ref": "#/$defs/constant", "minimum": 1 }],
                        "description": "largest ratio of the two sizes; default: automatic for solutions (as long as their L2 error gains), 1000000 for given functions" },
        "gradation": { "$ref": "#/$defs/constant", "minimum": 0, "default": 0,
                       "description": "the factor by which sizes may grow from edge to edge, above 1; 0: no limit" }
      }
    },
    "targets": {
      "description": "when the run is done; without any it ends when the first mesh no longer changes",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "l2_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                      "description": "of the solution, or of the interpolant where there is no equation; exact where 'exact' is given, else estimated" },
        "h1_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                      "description": "the same in the H1 seminorm, the L2 norm of the gradient's error" },
        "linf_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                        "description": "the same for the largest error" },
        "goal_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                        "description": "of the functional 'goal'; not with defect_correction" },
        "goal": { "type": "string", "minLength": 1,
                  "description": "the functional that meshes are made for; needed where there are several" },
        "vertices": { "type": "integer", "minimum": 3,
                      "description": "aim at this size, to 3 %; beside a target of an error: never ask for more" },
        "max_vertices": { "type": "integer", "minimum": 3, "description": "never ask for more; not below 'vertices'" },
        "max_iterations": { "type": "integer", "minimum": 1, "maximum": 10000, "default": 20,
                            "description": "meshes made, at most" },
        "max_seconds": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                         "description": "wall time after which no further mesh is begun; default: no limit" }
      }
    },
    "mesher": {
      "description": "how meshes are made",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "schedule": { "enum": ["fast", "thesis"], "default": "fast",
                      "description": "sweeps over all particles, or the random picks of Bossen's thesis" },
        "particles": { "$ref": "#/$defs/particles", "default": {},
                       "description": "how they act on each other, come and go" },
        "preset": { "enum": ["fast", "mid", "good"], "default": "good",
                    "description": "quality against time, of the schedule 'fast'" },
        "seed": { "type": "integer", "minimum": 0, "default": 1,
                  "description": "of the random picks of the schedule 'thesis'; 'fast' uses none" },
        "chord_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "default": 0.01,
                         "description": "how far edges may be from a curve, as a share of its extent" },
        "lower_error": { "type": "boolean", "default": false,
                         "description": "move vertices and swap edges at last to lower the L2 error itself; only with metric.norm 2, not with h1_error or a goal alone" }
      }
    },
    "particles": {
      "description": "numbers in the descriptions are those of the equations in Bossen's thesis (CMU-CS-96-134)",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "potential": { "enum": ["gaussian", "gaussian-derivative", "lennard-jones", "shimada",
                                "lennard-jones-approximation", "laplacian", "length-error", "ratio-error"],
                       "default": "lennard-jones-approximation",
                       "description": "of the force between particles, 3.16 to 3.25" },
        "decay": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 100, "default": 1,
                   "description": "d of 3.20, for the potential 'lennard-jones-approximation' only" },
        "neighbourhood": { "enum": ["n1", "n2", "radius"], "default": "n1",
                           "description": "who acts on a particle: neighbours in the triangulation, theirs too, or all within a radius" },
        "radius": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 10, "default": 1.5,
                    "description": "in unit edges, for the neighbourhood 'radius' only" },
        "force": { "enum": ["gradient", "along-edge"], "default": "along-edge",
                   "description": "its direction: 5.15 or 5.16" },
        "distance": { "enum": ["linear-metric", "mean-length", "mean-metric"], "default": "mean-metric",
                      "description": "how an edge is measured: 5.6, 5.7 or 5.8" },
        "step": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 10,
                  "description": "delta of 3.12; default: Newton's step on the hexagonal lattice times 1 - momentum" },
        "momentum": { "$ref": "#/$defs/constant", "minimum": 0, "maximum": 0.99,
                      "description": "beta of 3.13; 0: first order, 3.12; default: 0 with the schedule 'thesis', with 'fast' its own" },
        "virtual_triangles": { "type": "boolean", "default": true,
                               "description": "in the rule for creating particles, 3.4.2" },
        "creation": { "enum": ["midpoint", "circumcentre"], "default": "midpoint",
                      "description": "where: in the middle of the edge, or at the circumcentre of its larger triangle" },
        "annihilation": { "enum": ["removal", "collapse"],
                          "description": "how particles go: their star is triangulated again, or they merge into a neighbour; default: removal with the schedule 'thesis', collapse with 'fast'" },
        "alive_speed": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 0.99, "default": 0.01,
                         "description": "schedule 'thesis' only: slower particles die; unit edges per pick" },
        "relocation": { "enum": ["reinsert", "in-place"], "default": "reinsert",
                        "description": "schedule 'thesis' only: how a particle gets to its new place" },
        "picking": { "enum": ["uniform", "by-speed", "hilbert"], "default": "uniform",
                     "description": "schedule 'thesis' only: who moves next" },
        "max_picks": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 1e9, "default": 400,
                       "description": "schedule 'thesis' only: per particle, at most" }
      }
    },
    "initial": {
      "description": "how the run begins",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "vertices": { "type": "integer", "minimum": 3, "default": 400,
                      "description": "size of the uniform mesh to start from" },
        "continuation": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 1e12, "default": 1,
                          "description": "the first problems have the diffusion this many times as large, then a quarter of it, and so on down to the case's own; for diffusions under 1e-5" }
      }
    },
    "output": {
      "description": "which files the run leaves",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": { "formats": { "type": "array", "items": { "enum": ["vtu", "mesh", "msh", "svg", "png"] },
                                   "default": ["vtu", "mesh", "svg"],
                                   "description": "of the meshes: for ParaView, of Medit with the solution in .sol, of Gmsh, pictures" } }
    },
    "limits": {
      "description": "at least one of both",
      "type": "object", "minProperties": 1, "additionalProperties": false,
      "properties": { "min": { "$ref": "#/$defs/constant", "description": "the least that passes" },
                      "max": { "$ref": "#/$defs/constant", "description": "the most that passes" } }
    },
    "expect": {
      "type": "object",
      "description": "pass limits, checked by run --verify, on these fields of the last iteration in summary.json (adapt/README); targets_met is true or false",
      "patternProperties": { "^x-": {} },
      "properties": {
        "functionals": { "type": "object", "additionalProperties": { "$ref": "#/$defs/limits" },
                         "description": "name -> limits" },
        "fluxes": { "type": "object", "additionalProperties": { "$ref": "#/$defs/limits" },
                    "description": "side -> limits" }
      },
      "propertyNames": { "enum": [
        "targets_met", "iteration", "vertices", "triangles", "complexity", "efficiency", "unit_edges",
        "interpolation_error.l1", "interpolation_error.l2", "interpolation_error.linf", "interpolation_error.h1",
        "solution_error.l2", "solution_error.linf", "solution_error.h1", "estimated_error.l2", "estimated_error.h1",
        "estimated_error.linf", "estimated_error.h1_residual", "effectivity.l2", "effectivity.h1", "effectivity.h1_residual",
        "goal.value", "goal.estimate", "goal.error", "goal.corrected", "goal.corrected_error", "goal.effectivity",
        "edge_length.min", "edge_length.max", "quality.min", "quality.p01", "quality.mean",
        "quality.min_away_from_corners", "functionals", "fluxes", "bounds.lower", "bounds.upper", "bounds.overshoot",
        "bounds.undershoot", "solver.backward_error", "solver.unknowns", "solver.iterations", "solver.peclet_min",
        "solver.peclet_max", "solver.correction_change", "seconds.mesh", "seconds.solve", "seconds.recover", "seconds.total",
        "peak_memory_mb"] },
      "additionalProperties": { "anyOf": [{ "type": "boolean" }, { "$ref": "#/$defs/limits" }] }
    }
  }
})schema";

}  // namespace

// What a shape may have, the whole geometry may have too, and more: written out, so that who knows no
// unevaluatedProperties, such as the reader here, keeps other keys out.
nlohmann::ordered_json case_schema() {
  using Json = nlohmann::ordered_json;
  Json schema = Json::parse(kSchema);
  const Json& shape = schema["$defs"]["shape"];
  Json& geometry = schema["$defs"]["geometry"];
  const Json own = geometry;
  geometry = shape;
  geometry["description"] = own["description"];
  for (const auto& [name, property] : own["properties"].items()) geometry["properties"][name] = property;
  return schema;
}

}  // namespace parmesan
