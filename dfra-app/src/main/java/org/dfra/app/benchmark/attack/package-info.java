/**
 * What an attacker on the robot's network can do without a key, as programs: the benchmark {@code
 * attack} and the tests of {@code org.dfra.attack} run them against robots of their own.
 *
 * <pre>
 *   TaskProcess --starts--&gt; TaskMain --runs--&gt; Task
 *                              | SourceSockets: connects from the attacker's address
 *                              | Rebased: stock proxies that use these sockets
 *                              | RawCall + CallBytes: requests written by hand
 *   OtherUser --starts--&gt; the same, as a user without rights
 *   ProcessSample: threads, CPU time and heap of the attacked processes
 *   MeasuredValueLines: what an attack has measured itself, such as by a TerminalCheck
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.benchmark.attack.TaskProcess}.
 */
@NullMarked
package org.dfra.app.benchmark.attack;

import org.jspecify.annotations.NullMarked;
