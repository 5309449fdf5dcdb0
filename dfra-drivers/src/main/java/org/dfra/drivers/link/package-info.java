/**
 * Byte links between a driver and its device, named by a URL.
 *
 * <pre>
 *   serial:/dev/ttyS0?baud=9600   a serial port of this computer
 *   tcp://host:port               a serial server on the network, or an emulator
 *   replay:file?pace=1.0          recorded bytes, at the rate of the recorded line
 *   sim:name                      a simulated device in this virtual machine, in lock-step
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.link.LinkAddress}, which parses a URL and opens it as a
 * {@link org.dfra.drivers.link.SerialLink}. A driver does not open links itself: it passes a {@link
 * org.dfra.drivers.link.LinkHandler} to a {@link org.dfra.drivers.link.LinkKeeper}, whose thread
 * opens the link, reads it, and reopens it when it is lost.
 */
@NullMarked
package org.dfra.drivers.link;

import org.jspecify.annotations.NullMarked;
