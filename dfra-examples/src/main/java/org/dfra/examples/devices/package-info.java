/**
 * {@code ./dfra demo devices}: one robot in a simulated world with all its devices.
 *
 * <pre>
 *   sim run --bytes--&gt; drivers --events--&gt; ReadingRecorder --&gt; DevicesReport
 *           &lt;--bytes-- drive   &lt;--lease--- SquareScript
 * </pre>
 */
@NullMarked
package org.dfra.examples.devices;

import org.jspecify.annotations.NullMarked;
