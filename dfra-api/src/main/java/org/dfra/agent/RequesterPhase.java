package org.dfra.agent;

/**
 * What an agent that needs help is at.
 *
 * <pre>
 *   IDLE --call: HELP--&gt; CALLING --ACCEPT--&gt; COLLECTING --window: RESPONDER_ID--&gt; AWARDED
 *    ^                    |  ^                                                     |
 *    |     nobody in time |  '--- it did not come, refused, or left: replaced -----+ ARRIVAL:
 *    |&lt;-------------------'                     ^                                   | AGREE
 *    |                                          |                                  v
 *    '--lease over, or it is released-- DONE &lt;--'----ACK_ACK------------------- ON_SITE
 * </pre>
 */
public enum RequesterPhase {
  /** Needs nobody. */
  IDLE,
  /** Has called, and awaits a first offer; calls again at intervals. */
  CALLING,
  /** Has an offer, and awaits others for a short time. */
  COLLECTING,
  /** Has chosen one, and awaits its arrival. */
  AWARDED,
  /** Has heard that it arrived and agreed; awaits that it heard that. */
  ON_SITE,
  /** Is being helped; awaits the lease's end. */
  BEING_HELPED;

  /** Whether it looks for somebody, or waits for somebody to come. */
  public boolean isUnderWay() {
    return this != IDLE && this != BEING_HELPED;
  }
}
