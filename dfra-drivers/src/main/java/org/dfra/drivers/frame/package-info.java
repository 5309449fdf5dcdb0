/**
 * Frames in a stream of bytes: what the protocols of all devices on a link have in common.
 *
 * <p>Enter at {@link org.dfra.drivers.frame.FrameParser}. A protocol adds the rule that tells a
 * frame from anything else, as a {@link org.dfra.drivers.frame.FrameScanner}, and a decoder. What
 * has no frames that tell themselves from anything else, as HTTP, is another {@link
 * org.dfra.drivers.frame.StreamParser}.
 */
@NullMarked
package org.dfra.drivers.frame;

import org.jspecify.annotations.NullMarked;
