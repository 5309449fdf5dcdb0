/**
 * Attacks that need only access to the robot's network and no key, as programs: the benchmark
 * {@code attack} and the tests of {@code org.dfra.attack} run them against their own robots.
 *
 * <pre>
 *   TaskProcess --starts--&gt; TaskMain --runs--&gt; Task
 *                              | SourceSockets: connects from the attacker's address
 *                              | SourceBoundProxies: stock proxies that use these sockets
 *                              | RawCall + CallBytes: requests that are hand-written
 *   OtherUser --starts--&gt; the same, as an unprivileged user
 *   ProcessSample: threads, CPU time and heap of the attacked processes
 *   MeasuredValueLines: an attack's own measurements, such as by a TerminalCheck
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.benchmarks.task.TaskProcess}.
 */
@NullMarked
package org.dfra.benchmarks.attack;

import org.jspecify.annotations.NullMarked;
