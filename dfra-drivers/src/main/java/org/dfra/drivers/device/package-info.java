/**
 * A device at the far end of a link: the common base of all device drivers.
 *
 * <pre>
 *   LinkKeeper --bytes--&gt; DeviceLink --feeds--&gt; the protocol's FrameParser --messages--&gt; driver
 *              &lt;--bytes--            &lt;--send--                                        driver
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.device.DeviceLink}; a sensor extends {@link
 * org.dfra.drivers.device.LinkedSensorImpl}. A driver supplies its {@link
 * org.dfra.drivers.device.DeviceProtocol}. A {@link org.dfra.core.module.LatestReading} keeps the
 * last reading and the readiness that follows from it. Where several modules share one link, enter
 * at {@link org.dfra.drivers.device.SharedDeviceLink}.
 */
@NullMarked
package org.dfra.drivers.device;

import org.jspecify.annotations.NullMarked;
