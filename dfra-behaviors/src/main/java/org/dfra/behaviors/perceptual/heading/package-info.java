/**
 * How a robot stands to the way it is to go. Enter at {@link
 * org.dfra.behaviors.perceptual.heading.HeadingErrorImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.heading;

import org.jspecify.annotations.NullMarked;
