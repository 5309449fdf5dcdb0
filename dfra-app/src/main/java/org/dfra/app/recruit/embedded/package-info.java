/**
 * The experiment's agents over real JERI: a lookup service, exported agents found in it by what
 * they can observe, remote events over the loopback.
 *
 * <pre>
 *   Experiment --&gt; FieldRun --Member--&gt; EmbeddedVenue --Seat--&gt; FieldAgent (a Recruiter)
 *                                            |                     ^
 *                                       registrar, servers     AgentMessageEvent by JERI
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.recruit.embedded.EmbeddedRuns}.
 */
@NullMarked
package org.dfra.app.recruit.embedded;

import org.jspecify.annotations.NullMarked;
