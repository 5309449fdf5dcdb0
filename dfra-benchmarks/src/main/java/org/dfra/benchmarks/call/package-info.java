/**
 * The latency of a remote call between two processes, by DFRA and by other ways to call: {@code
 * ./dfra bench call}. A server's process and a client's process are started for each peer; the
 * benchmark's own process commands both and reads their counters from {@code /proc}:
 *
 * <pre>
 *   benchmark ----&gt; CallClientTask ----peer----&gt; CallServerTask
 *       |           calls, checks, times         answers
 *       +---------------------------------------------^
 *          starts, reads context switches and CPU time
 * </pre>
 *
 * <p>Enter at {@link org.dfra.benchmarks.call.CallComparison}; another peer is another constant of
 * {@link org.dfra.benchmarks.call.CallPeer}.
 */
@NullMarked
package org.dfra.benchmarks.call;

import org.jspecify.annotations.NullMarked;
