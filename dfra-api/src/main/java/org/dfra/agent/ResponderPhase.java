package org.dfra.agent;

/**
 * What an agent is at that may help others.
 *
 * <pre>
 *          it accepts: ACCEPT            RESPONDER_ID names it
 *   FREE --------------------&gt; OFFERED -----------------------&gt; TRAVELLING
 *    ^                            |                               |    | is there: ARRIVAL
 *    |&lt;--another, no answer-------'     cannot, too late, not     |    v
 *    |&lt;---------------------------------- wanted any more --------'  ARRIVED
 *    |&lt;--no answer, released-----------------------------------------|  | AGREE: ACK_ACK
 *    |                                                                  v
 *    '--lease over, released----------------------------------------- LEASED
 * </pre>
 */
public enum ResponderPhase {
  /** Helps nobody. */
  FREE,
  /** Has offered to come, and awaits who was chosen; goes on with what it did. */
  OFFERED,
  /** Is on its way; awaits to be there. */
  TRAVELLING,
  /** Is there and says so; awaits the requester's agreement. */
  ARRIVED,
  /** Observes for the requester; awaits the lease's end. */
  LEASED;

  /** Whether it left what it did, for a requester. */
  public boolean isCommitted() {
    return this != FREE && this != OFFERED;
  }
}
