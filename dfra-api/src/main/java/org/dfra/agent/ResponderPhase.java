package org.dfra.agent;

/**
 * The phase of an agent that may help others.
 *
 * <pre>
 *          it accepts: ACCEPT            RESPONDER_ID names it
 *   FREE --------------------&gt; OFFERED -----------------------&gt; TRAVELLING
 *    ^                            |                               |    | arrived: ARRIVAL
 *    |&lt;--another, no answer-------'     failed, too late, not     |    v
 *    |&lt;---------------------------------- needed any more --------'  ARRIVED
 *    |&lt;--no answer, released-----------------------------------------|  | AGREE: ACK_ACK
 *    |                                                                  v
 *    '--lease over, released----------------------------------------- LEASED
 * </pre>
 */
public enum ResponderPhase {
  /** Helps no robot. */
  FREE,
  /** Has offered to help, and awaits the requester's choice; continues its own work. */
  OFFERED,
  /** Drives to the place. */
  TRAVELLING,
  /** Has arrived and reports it; awaits the requester's agreement. */
  ARRIVED,
  /** Observes for the requester until the lease ends. */
  LEASED;

  /** Whether it has interrupted its own work for a requester. */
  public boolean isCommitted() {
    return this != FREE && this != OFFERED;
  }
}
