/**
 * Where a robot's frames stand in each other. Enter at {@link org.dfra.core.geometry.FrameTree}.
 */
@NullMarked
package org.dfra.core.geometry;

import org.jspecify.annotations.NullMarked;
