#include "procedural/curves.h"
