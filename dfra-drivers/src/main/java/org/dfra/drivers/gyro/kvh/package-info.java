/**
 * The fibre-optic rate gyro KVH DSP-3000, with its ASCII protocol.
 *
 * <pre>
 *   bytes --&gt; Dsp3000Framer --lines--&gt; Dsp3000Decoder --Dsp3000Message--&gt; Dsp3000Impl
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gyro.kvh.Dsp3000Impl}. Source: what its public drivers agree
 * on, because its manual was not available; the reference page lists the source of each item.
 */
@NullMarked
package org.dfra.drivers.gyro.kvh;

import org.jspecify.annotations.NullMarked;
