/**
 * Frames in a stream of bytes: what the protocols of all devices on a link have in common.
 *
 * <p>Enter at {@link org.dfra.drivers.frame.FrameParser}. A protocol adds the rule that tells a
 * frame from anything else, as a {@link org.dfra.drivers.frame.FrameScanner}, and a decoder.
 */
@NullMarked
package org.dfra.drivers.frame;

import org.jspecify.annotations.NullMarked;
