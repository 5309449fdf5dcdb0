/**
 * The latency of events to listeners in other processes, beside that of a bare TCP program.
 *
 * <pre>
 *   EventComparison --&gt; EventProcesses --&gt; EventServerTask --EventTransport--&gt; EventListenerTask
 * </pre>
 *
 * <p>Start at {@link org.dfra.benchmarks.event.EventComparison}. A further way is one constant of
 * {@link org.dfra.benchmarks.event.EventPeer}.
 */
@NullMarked
package org.dfra.benchmarks.event;

import org.jspecify.annotations.NullMarked;
