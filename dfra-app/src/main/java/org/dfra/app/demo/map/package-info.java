/**
 * Maps for the reports of demonstrations that move on a field: what stands there, where robots
 * truly went, and what happened where. Enter at {@link org.dfra.app.demo.map.FieldMap}.
 */
@NullMarked
package org.dfra.app.demo.map;

import org.jspecify.annotations.NullMarked;
