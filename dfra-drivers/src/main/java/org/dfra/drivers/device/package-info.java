/**
 * A device at the far end of a link: what the drivers of all of them have in common.
 *
 * <pre>
 *   LinkKeeper --bytes--&gt; DeviceLink --feeds--&gt; the protocol's FrameParser --messages--&gt; driver
 *              &lt;--bytes--            &lt;--send--                                        driver
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.device.DeviceLink}; a driver brings its {@link
 * org.dfra.drivers.device.DeviceProtocol}. What the device last told, and the readiness that
 * follows from it, is kept by a {@link org.dfra.drivers.device.LatestReading}. Where several
 * modules are behind one link, enter at {@link org.dfra.drivers.device.SharedDeviceLink}.
 */
@NullMarked
package org.dfra.drivers.device;

import org.jspecify.annotations.NullMarked;
