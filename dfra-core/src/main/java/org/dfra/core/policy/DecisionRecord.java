package org.dfra.core.policy;

import java.time.Instant;
import org.dfra.security.AccessRequest;
import org.dfra.security.Decision;

/**
 * A decision about a call, for the log and the audit trail.
 *
 * @param time when it was made, by the robot's clock
 * @param request who called what; the caller of another team is a stranger in it
 * @param decision the decision, which names its rule
 * @param policyVersion version of the policy that has the rule
 * @param obligations what the rule obliges to; those about logging and notifying are the listener's
 */
public record DecisionRecord(
    Instant time,
    AccessRequest request,
    Decision decision,
    long policyVersion,
    Obligations obligations) {}
