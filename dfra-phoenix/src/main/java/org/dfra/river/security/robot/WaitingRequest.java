package org.dfra.river.security.robot;

import java.io.Serializable;

/**
 * A call that waits for an operator's confirmation.
 *
 * @param id by which it is answered
 * @param robot whose object was called
 * @param object name of the called object; empty if it has none
 * @param method such as {@code Effector.execute}
 * @param caller who has called, and from which address
 * @param rule name of the rule that asks
 * @param secondsLeft how long it waits still
 */
public record WaitingRequest(
    String id,
    String robot,
    String object,
    String method,
    String caller,
    String rule,
    long secondsLeft)
    implements Serializable {}
