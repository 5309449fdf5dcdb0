/**
 * The fibre-optic rate gyro KVH DSP-3000, by its lines in ASCII.
 *
 * <pre>
 *   bytes --&gt; Dsp3000Framer --lines--&gt; Dsp3000Decoder --Dsp3000Message--&gt; Dsp3000Impl
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gyro.kvh.Dsp3000Impl}. Source: what public drivers of it
 * agree on, since its manual was not at hand; the reference page says which is which.
 */
@NullMarked
package org.dfra.drivers.gyro.kvh;

import org.jspecify.annotations.NullMarked;
