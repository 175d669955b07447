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
    "name": { "type": "string", "description": "names the output folder; default: the file's name, with _ for what is no letter or digit" },
    "title": { "type": "string", "default": "", "description": "shown in reports" },
    "parameters": {
      "type": "object", "default": {}, "additionalProperties": { "$ref": "#/$defs/parameter" },
      "description": "constants for expressions; one may use those before it"
    },
    "geometry": { "$ref": "#/$defs/geometry" },
    "problem": { "anyOf": [{ "$ref": "#/$defs/interpolation" }, { "$ref": "#/$defs/equation" }] },
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
      "type": "object", "required": ["min", "max"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": { "min": { "$ref": "#/$defs/point" }, "max": { "$ref": "#/$defs/point" } }
    },
    "disc": {
      "type": "object", "required": ["radius"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0] },
        "radius": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 },
        "points": { "type": "integer", "minimum": 3, "maximum": 1000000,
                    "description": "corners of a regular polygon in place of the circle" }
      }
    },
    "arc": {
      "type": "object", "required": ["radius", "from", "to"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0] },
        "radius": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 },
        "from": { "$ref": "#/$defs/constant", "description": "degrees against the x axis" },
        "to": { "$ref": "#/$defs/constant", "description": "below from: clockwise" }
      }
    },
    "ellipse": {
      "type": "object", "required": ["axes"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0] },
        "axes": { "$ref": "#/$defs/positive_pair", "description": "half the length of each" },
        "rotation": { "$ref": "#/$defs/constant", "default": 0, "description": "of the first axis, degrees" },
        "from": { "$ref": "#/$defs/constant", "default": 0, "description": "degrees of its parameter" },
        "to": { "$ref": "#/$defs/constant", "default": 360 }
      }
    },
    "whole_ellipse": {
      "type": "object", "required": ["axes"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "center": { "$ref": "#/$defs/point", "default": [0, 0] },
        "axes": { "$ref": "#/$defs/positive_pair", "description": "half the length of each" },
        "rotation": { "$ref": "#/$defs/constant", "default": 0, "description": "of the first axis, degrees" }
      }
    },
    "positive_pair": { "title": "two positive numbers [a, b]", "type": "array",
                       "items": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 }, "minItems": 2, "maxItems": 2 },
    "spline": {
      "type": "object", "required": ["points"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" }, "description": "control points" },
        "degree": { "type": "integer", "minimum": 1, "maximum": 16, "default": 3 },
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
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" } },
        "closed": { "type": "boolean", "default": false,
                    "description": "true: smoothly back to the first point; else the ends are without curvature" }
      }
    },
    "parametric": {
      "type": "object", "required": ["x", "y"], "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "x": { "$ref": "#/$defs/scalar", "description": "of t" },
        "y": { "$ref": "#/$defs/scalar", "description": "of t" },
        "from": { "$ref": "#/$defs/constant", "default": 0 }, "to": { "$ref": "#/$defs/constant", "default": 1 }
      }
    },
    "piece": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["line"] }, { "required": ["arc"] }, { "required": ["ellipse"] },
                { "required": ["spline"] }, { "required": ["through"] }, { "required": ["parametric"] }],
      "properties": {
        "line": { "title": "a list of at least 2 points", "type": "array", "items": { "$ref": "#/$defs/point" },
                  "minItems": 2 },
        "arc": { "$ref": "#/$defs/arc" }, "ellipse": { "$ref": "#/$defs/ellipse" },
        "spline": { "$ref": "#/$defs/spline" }, "through": { "$ref": "#/$defs/through" },
        "parametric": { "$ref": "#/$defs/parametric" },
        "label": { "type": "string", "minLength": 1 }
      }
    },
    "path": { "title": "a list of pieces, each from where the one before ends", "type": "array",
              "items": { "$ref": "#/$defs/piece" }, "minItems": 1 },
    "naca": {
      "type": "object", "required": ["code"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "code": { "type": "string", "description": "four digits, such as 0012 or 2412, or five, such as 23012" },
        "chord": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "default": 1 },
        "angle": { "$ref": "#/$defs/constant", "minimum": -90, "maximum": 90, "default": 0,
                   "description": "angle of attack in degrees, nose up" },
        "position": { "$ref": "#/$defs/point", "default": [0, 0], "description": "of the leading edge" },
        "points": { "type": "integer", "minimum": 8, "maximum": 100000,
                    "description": "corners of a polygon in place of the airfoil" },
        "channel": { "$ref": "#/$defs/box", "description": "only shapes of operations do without" }
      }
    },
    "hole": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["polygon"] }, { "required": ["disc"] }, { "required": ["ellipse"] },
                { "required": ["curves"] }],
      "properties": {
        "polygon": { "$ref": "#/$defs/ring" },
        "disc": { "$ref": "#/$defs/disc" },
        "ellipse": { "$ref": "#/$defs/whole_ellipse" },
        "curves": { "$ref": "#/$defs/path" },
        "label": { "type": "string", "minLength": 1 }
      }
    },
    "segment": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["from"] }, { "required": ["arc"] }, { "required": ["ellipse"] },
                { "required": ["spline"] }, { "required": ["through"] }, { "required": ["parametric"] }],
      "properties": {
        "from": { "$ref": "#/$defs/point" }, "to": { "$ref": "#/$defs/point" },
        "arc": { "$ref": "#/$defs/arc" }, "ellipse": { "$ref": "#/$defs/ellipse" },
        "spline": { "$ref": "#/$defs/spline" }, "through": { "$ref": "#/$defs/through" },
        "parametric": { "$ref": "#/$defs/parametric" },
        "label": { "type": "string", "minLength": 1, "default": "inside" },
        "label_right": { "type": "string", "minLength": 1,
                         "description": "makes it a crack: the label of its side to the right of its direction" },
        "required": { "type": "boolean", "description": "true: stays one edge of every mesh" }
      }
    },
    "shapes": { "title": "a list of at least 2 shapes", "type": "array", "items": { "$ref": "#/$defs/shape" },
                "minItems": 2 },
    "shape": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["rectangle"] }, { "required": ["disc"] }, { "required": ["ellipse"] },
                { "required": ["polygon"] }, { "required": ["curves"] }, { "required": ["naca"] },
                { "required": ["file"] }, { "required": ["union"] }, { "required": ["intersection"] },
                { "required": ["difference"] }],
      "properties": {
        "rectangle": { "$ref": "#/$defs/box", "description": "sides: left, right, bottom, top" },
        "disc": { "$ref": "#/$defs/disc", "description": "side: circle" },
        "ellipse": { "$ref": "#/$defs/whole_ellipse", "description": "side: ellipse" },
        "polygon": { "$ref": "#/$defs/ring", "description": "side: boundary, unless labels are given" },
        "curves": { "$ref": "#/$defs/path", "description": "sides: boundary, unless pieces have labels" },
        "naca": { "$ref": "#/$defs/naca", "description": "sides: airfoil, left, right, bottom, top" },
        "file": { "type": "string", "minLength": 1, "description": "beside or below the case file" },
        "union": { "$ref": "#/$defs/shapes", "description": "what is in any of them" },
        "intersection": { "$ref": "#/$defs/shapes", "description": "what is in all of them" },
        "difference": { "$ref": "#/$defs/shapes", "description": "what is in the first and in none of the others" },
        "labels": {
          "anyOf": [
            { "title": "a list with a name per side of the polygon", "type": "array",
              "items": { "type": "string", "minLength": 1 } },
            { "title": "an object side -> new name", "type": "object",
              "additionalProperties": { "type": "string", "minLength": 1 } }]
        },
        "holes": {
          "type": "array",
          "items": { "anyOf": [{ "$ref": "#/$defs/ring" }, { "$ref": "#/$defs/hole" }] },
          "description": "sides: hole1, hole2, ..., unless a label is given"
        }
      }
    },
    "geometry": {
      "properties": {
        "regions": { "type": "object", "additionalProperties": { "$ref": "#/$defs/point" },
                     "description": "name -> a point in the region" },
        "merge_tolerance": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0,
                             "description": "points nearer than this become one, with a warning" },
        "required": { "type": "array", "items": { "type": "string", "minLength": 1 },
                      "description": "regions whose triangles stay as the file, or the first mesh, has them" },
        "points": { "type": "array", "items": { "$ref": "#/$defs/point" }, "description": "vertices inside" },
        "segments": { "type": "array", "items": { "$ref": "#/$defs/segment" }, "description": "edges and cracks inside" }
      }
    },
    "interpolation": {
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
                  "description": "beside or below the case file: .sol, .solb, or a mesh file with fields" },
        "mesh": { "type": "string", "minLength": 1, "description": "beside or below the case file" },
        "field": { "type": "string", "minLength": 1, "description": "which one, where the file has several" }
      }
    },
    "equation": {
      "description": "-div(diffusion grad u) + velocity.grad u + reaction u = source",
      "type": "object", "required": ["boundary"], "additionalProperties": false,
      "patternProperties": { "^x-": {} },
      "properties": {
        "diffusion": { "$ref": "#/$defs/tensor_field", "default": 1 },
        "velocity": { "$ref": "#/$defs/vector_field", "default": [0, 0] },
        "reaction": { "$ref": "#/$defs/scalar_field", "default": 0 },
        "source": { "$ref": "#/$defs/scalar_field", "description": "default: derived from exact, else 0" },
        "point_sources": { "type": "array", "items": { "$ref": "#/$defs/point_source" } },
        "exact": { "$ref": "#/$defs/scalar", "description": "the exact solution" },
        "stabilize": { "type": "boolean", "default": true,
                       "description": "SUPG where the mesh Peclet number exceeds 1" },
        "discontinuity_capturing": { "type": "boolean", "default": false,
                                     "description": "diffusion across the flow where layers are not resolved" },
        "defect_correction": { "type": "boolean", "default": false,
                               "description": "adds to nodal values what Galerkin's method lacks at the vertices" },
        "boundary": { "type": "object", "minProperties": 1, "additionalProperties": { "$ref": "#/$defs/condition" },
                      "description": "per label, \"*\" for all others" }
      }
    },
    "point_source": {
      "type": "object", "required": ["at", "strength"], "additionalProperties": false,
      "patternProperties": { "^x-": {} }, "description": "strength times the delta distribution, added to the source",
      "properties": { "at": { "$ref": "#/$defs/point" }, "strength": { "$ref": "#/$defs/constant" } }
    },
    "functional": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["integral"] }, { "required": ["boundary_integral"] }, { "required": ["flux"] },
                { "required": ["value"] }],
      "properties": {
        "integral": { "type": "string", "minLength": 1, "description": "of u over a region, \"*\" for the domain" },
        "boundary_integral": { "type": "string", "minLength": 1, "description": "of u over the sides of a label" },
        "flux": { "type": "string", "minLength": 1, "description": "integral of n.K grad u over the sides of a label" },
        "value": { "$ref": "#/$defs/point", "description": "u at a point" },
        "weight": { "$ref": "#/$defs/scalar", "description": "a factor of u in an integral" },
        "exact": { "$ref": "#/$defs/constant", "description": "its value for the exact solution, where known" }
      }
    },
    "condition": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "oneOf": [{ "required": ["dirichlet"] }, { "required": ["neumann"] }, { "required": ["robin"] }],
      "properties": {
        "dirichlet": { "$ref": "#/$defs/scalar", "description": "u" },
        "neumann": { "$ref": "#/$defs/scalar", "description": "n.K grad u" },
        "robin": {
          "type": "object", "required": ["coefficient", "value"], "additionalProperties": false,
          "patternProperties": { "^x-": {} }, "description": "n.K grad u + coefficient u = value",
          "properties": { "coefficient": { "$ref": "#/$defs/scalar" }, "value": { "$ref": "#/$defs/scalar" } }
        }
      }
    },
    "solver": {
      "description": "of the linear systems; what is automatic depends on the size and the kind of the matrix",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "method": { "enum": ["automatic", "ldlt", "lu", "cg", "bicgstab", "gmres"], "default": "automatic",
                    "description": "tried first; direct methods follow where it fails" },
        "preconditioner": { "enum": ["automatic", "jacobi", "ilut", "multigrid"], "default": "automatic",
                            "description": "of iterative methods" },
        "restart": { "type": "integer", "minimum": 1, "maximum": 1000, "default": 50,
                     "description": "vectors that gmres keeps" }
      }
    },
    "metric": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "kind": { "enum": ["sign-aware", "loseille-alauzet"], "default": "sign-aware" },
        "norm": { "anyOf": [{ "type": "number", "minimum": 1 },
                            { "enum": ["inf"] }], "default": 2,
                  "description": "p of the Lp norm of the error to minimise" },
        "recovery": { "enum": ["least-squares", "double-projection", "zienkiewicz-zhu", "polynomial-preserving", "exact"],
                      "description": "of derivatives; default: zienkiewicz-zhu of solutions, least-squares of given functions" },
        "interpolation": { "enum": ["log-euclidean", "linear"], "default": "log-euclidean",
                           "description": "of metrics between the vertices of the previous mesh; linear as in the thesis" },
        "h_min": { "$ref": "#/$defs/scalar", "minimum": 0, "default": 0,
                   "description": "smallest size, may vary with x and y; 0: none" },
        "h_max": { "$ref": "#/$defs/scalar", "minimum": 0, "default": 0,
                   "description": "largest size, may vary with x and y; 0: a quarter of the diagonal of the domain's box" },
        "max_aspect": { "anyOf": [{ "enum": ["automatic"] }, { "$ref": "#/$defs/constant", "minimum": 1 }],
                        "description": "largest ratio of the two sizes; default: automatic for solutions (as long as their L2 error gains), 1000000 for given functions" },
        "gradation": { "$ref": "#/$defs/constant", "minimum": 0, "default": 0,
                       "description": "growth of size per unit metric length, above 1; 0: none" }
      }
    },
    "targets": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "l2_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 },
        "h1_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 },
        "linf_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 },
        "goal_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "description": "of the functional 'goal'" },
        "goal": { "type": "string", "minLength": 1,
                  "description": "the functional that meshes are made for; needed where there are several" },
        "vertices": { "type": "integer", "minimum": 3, "description": "aim at this size" },
        "max_vertices": { "type": "integer", "minimum": 3, "description": "never ask for more" },
        "max_iterations": { "type": "integer", "minimum": 1, "maximum": 10000, "default": 20 },
        "max_seconds": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0 }
      }
    },
    "mesher": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "schedule": { "enum": ["fast", "thesis"], "default": "fast",
                      "description": "sweeps, or the random picks of the thesis" },
        "particles": { "$ref": "#/$defs/particles", "default": {} },
        "preset": { "enum": ["fast", "mid", "good"], "default": "good" },
        "seed": { "type": "integer", "minimum": 0, "default": 1,
                  "description": "of the random engine, from which only the schedule \"thesis\" draws" },
        "chord_error": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "default": 0.01,
                         "description": "how far edges may be from a curve, as a share of its extent" },
        "lower_error": { "type": "boolean", "default": false,
                         "description": "move vertices and swap edges last to lower the L2 error itself" }
      }
    },
    "particles": {
      "description": "how particles act on each other, come and go; the numbers are the thesis's equations",
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "potential": { "enum": ["gaussian", "gaussian-derivative", "lennard-jones", "shimada",
                                "lennard-jones-approximation", "laplacian", "length-error", "ratio-error"],
                       "default": "lennard-jones-approximation" },
        "decay": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 100, "default": 1,
                   "description": "d of the approximation 3.20" },
        "neighbourhood": { "enum": ["n1", "n2", "radius"], "default": "n1" },
        "radius": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 10, "default": 1.5,
                    "description": "in unit edges" },
        "force": { "enum": ["gradient", "along-edge"], "default": "along-edge", "description": "5.15 or 5.16" },
        "distance": { "enum": ["linear-metric", "mean-length", "mean-metric"], "default": "mean-metric",
                      "description": "5.6, 5.7 or 5.8" },
        "step": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 10,
                  "description": "delta of 3.12; without it from Newton's step on the hexagonal lattice" },
        "momentum": { "$ref": "#/$defs/constant", "minimum": 0, "maximum": 0.99,
                      "description": "beta of 3.13; 0: first order, 3.12; without it the schedule's own" },
        "virtual_triangles": { "type": "boolean", "default": true },
        "creation": { "enum": ["midpoint", "circumcentre"], "default": "midpoint" },
        "annihilation": { "enum": ["removal", "collapse"],
                          "description": "without it the schedule's own: collapse, in that of the thesis removal" },
        "alive_speed": { "$ref": "#/$defs/constant", "exclusiveMinimum": 0, "maximum": 0.99, "default": 0.01,
                         "description": "schedule thesis: slower particles die; unit edges per pick" },
        "relocation": { "enum": ["reinsert", "in-place"], "default": "reinsert", "description": "schedule thesis" },
        "picking": { "enum": ["uniform", "by-speed", "hilbert"], "default": "uniform",
                     "description": "schedule thesis" },
        "max_picks": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 1e9, "default": 400,
                       "description": "schedule thesis: per particle" }
      }
    },
    "initial": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": {
        "vertices": { "type": "integer", "minimum": 3, "default": 400,
                      "description": "size of the uniform mesh to start from" },
        "continuation": { "$ref": "#/$defs/constant", "minimum": 1, "maximum": 1e12, "default": 1,
                          "description": "the first problems have the diffusion this many times as large, then a quarter of it, and so on down to the case's own" }
      }
    },
    "output": {
      "type": "object", "additionalProperties": false, "patternProperties": { "^x-": {} },
      "properties": { "formats": { "type": "array", "items": { "enum": ["vtu", "mesh", "msh", "svg", "png"] },
                                   "default": ["vtu", "mesh", "svg"] } }
    },
    "limits": {
      "type": "object", "minProperties": 1, "additionalProperties": false,
      "properties": { "min": { "$ref": "#/$defs/constant" }, "max": { "$ref": "#/$defs/constant" } }
    },
    "expect": {
      "type": "object", "description": "pass limits on fields of the last iteration in summary.json",
      "patternProperties": { "^x-": {} },
      "properties": {
        "functionals": { "type": "object", "additionalProperties": { "$ref": "#/$defs/limits" } },
        "fluxes": { "type": "object", "additionalProperties": { "$ref": "#/$defs/limits" } }
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
  const Json own = geometry["properties"];
  geometry = shape;
  for (const auto& [name, property] : own.items()) geometry["properties"][name] = property;
  return schema;
}

}  // namespace parmesan
