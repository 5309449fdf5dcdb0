/**
 * Frames in a stream of bytes: the common base of all device protocols.
 *
 * <p>Enter at {@link org.dfra.drivers.frame.FrameParser}. A protocol adds a {@link
 * org.dfra.drivers.frame.FrameScanner}, which recognizes frames, and a decoder. A protocol without
 * recognizable frames, such as HTTP, implements {@link org.dfra.drivers.frame.StreamParser}
 * directly.
 */
@NullMarked
package org.dfra.drivers.frame;

import org.jspecify.annotations.NullMarked;
