/**
 * Heading error and cross-track error to the planned leg. Enter at {@link
 * org.dfra.behaviors.perceptual.heading.HeadingErrorImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.heading;

import org.jspecify.annotations.NullMarked;
