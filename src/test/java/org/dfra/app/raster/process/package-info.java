/** A search by raster in real processes, some of which are killed on the way. */
@NullMarked
package org.dfra.app.raster.process;

import org.jspecify.annotations.NullMarked;
