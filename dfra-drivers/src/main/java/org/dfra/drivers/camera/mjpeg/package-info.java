/**
 * Network cameras that stream images over HTTP, as {@code multipart/x-mixed-replace}: visible light
 * as JPEG, thermal as 16-bit PNG.
 *
 * <pre>
 *   bytes --&gt; MjpegParser --MjpegMessage: Response, Part ...--&gt; MjpegProtocol --&gt; MjpegCameraImpl
 *             HttpHeader, ImageFormat
 *   SuspendableLink: the connection, closed while there are no clients
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.camera.mjpeg.MjpegCameraImpl}. Sources: RFC 9110 and 9112
 * (HTTP), RFC 2046 section 5.1 (multipart), RFC 7617 (basic authentication), ITU-T T.81 (JPEG), the
 * PNG specification.
 */
@NullMarked
package org.dfra.drivers.camera.mjpeg;

import org.jspecify.annotations.NullMarked;
