/**
 * The experiment's agents over real JERI: a lookup service, exported agents discovered by their
 * sensors, remote events over the loopback.
 *
 * <pre>
 *   Experiment --&gt; FieldRun --Member--&gt; EmbeddedEnvironment --AgentSlot--&gt; FieldAgent
 *                                            |                          ^
 *                                       registrar, servers          AgentMessageEvent by JERI
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.experiments.recruit.embedded.EmbeddedRuns}.
 */
@NullMarked
package org.dfra.experiments.recruit.embedded;

import org.jspecify.annotations.NullMarked;
