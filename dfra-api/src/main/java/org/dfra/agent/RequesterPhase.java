package org.dfra.agent;

/**
 * The phase of an agent that needs help.
 *
 * <pre>
 *   IDLE --call: HELP--&gt; CALLING --ACCEPT--&gt; COLLECTING --window: RESPONDER_ID--&gt; AWARDED
 *    ^                    |  ^                                                     |
 *    |   no offer in time |  '--- no arrival, refused, or left: replaced ----------+ ARRIVAL:
 *    |&lt;-------------------'                     ^                                   | AGREE
 *    |                                          |                                  v
 *    '--lease over, or it is released-- DONE &lt;--'----ACK_ACK------------------- ON_SITE
 * </pre>
 */
public enum RequesterPhase {
  /** Needs no help. */
  IDLE,
  /** Has called, and awaits the first offer; repeats the call at intervals. */
  CALLING,
  /** Has an offer, and awaits further offers for a short time. */
  COLLECTING,
  /** Has chosen a helper, and awaits its arrival. */
  AWARDED,
  /** Has received the helper's arrival and agreed; awaits the acknowledgement. */
  ON_SITE,
  /** Is being helped until the lease ends. */
  BEING_HELPED;

  /** Whether it searches for a helper or awaits a helper's arrival. */
  public boolean isUnderWay() {
    return this != IDLE && this != BEING_HELPED;
  }
}
