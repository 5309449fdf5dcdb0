/** The tree of a robot's coordinate frames. Start at {@link org.dfra.core.geometry.FrameTree}. */
@NullMarked
package org.dfra.core.geometry;

import org.jspecify.annotations.NullMarked;
