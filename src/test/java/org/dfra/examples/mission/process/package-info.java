/** A search by raster in real processes, some of which are killed on the way. */
@NullMarked
package org.dfra.examples.mission.process;

import org.jspecify.annotations.NullMarked;
