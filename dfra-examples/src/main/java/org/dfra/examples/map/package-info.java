/**
 * Maps for the reports of demonstrations that move on a field: obstacles, the robots' true paths,
 * and the places of events. Entry point: {@link org.dfra.examples.map.FieldMap}.
 */
@NullMarked
package org.dfra.examples.map;

import org.jspecify.annotations.NullMarked;
