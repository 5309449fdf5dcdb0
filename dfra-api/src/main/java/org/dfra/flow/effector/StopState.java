package org.dfra.flow.effector;

import java.io.Serializable;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Whether an effector is stopped for an emergency, see {@link Effector#emergencyStop}.
 *
 * @param latched whether it is: then it obeys nobody until it is released
 * @param by who stopped it, or released it last, for people; null where nobody ever did, or nobody
 *     knows any more
 * @param since when that was, by the effector's clock, UTC, whole milliseconds; null likewise
 * @param resting whether its driver has been told to come to rest; false only while it is latched
 *     and the driver is held up, or where the driver failed
 * @param fault what is wrong with it, a clause or two for people; null where nothing is
 */
public record StopState(
    boolean latched,
    @Nullable String by,
    @Nullable Instant since,
    boolean resting,
    @Nullable String fault)
    implements Serializable {

  /** Of an effector that was never stopped. */
  public static final StopState NEVER = new StopState(false, null, null, true, null);

  /** Since when it is stopped and by whom, as far as that is known; for people. */
  public String inWords() {
    return (since == null ? "since a time not known" : "since " + since)
        + (by == null ? "" : ", by " + by);
  }
}
