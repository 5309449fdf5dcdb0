package org.dfra.core.policy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.jspecify.annotations.Nullable;

/**
 * The calls that wait for an operator's confirmation. A confirmation is for one call of the same
 * caller, on the same behalf, of the same method, object and rule. Thread-safe.
 *
 * <p>The memory is bounded: at most {@value #MAX_REQUESTS} requests are kept, and {@value
 * #MAX_OF_CALLER} of one caller. Requests that nobody answers are dropped after {@value
 * #KEPT_SECONDS} s, and so are answers.
 */
public final class ConfirmationRequests implements Confirmations {

  /** The most requests. */
  public static final int MAX_REQUESTS = 64;

  /** The most requests of one caller. */
  public static final int MAX_OF_CALLER = 4;

  /** How long a request waits, and how long an answer counts, in seconds. */
  public static final int KEPT_SECONDS = 300;

  /** Without those that are easily confused. */
  private static final String ID_CHARACTERS = "abcdefghjkmnpqrstuvwxyz23456789";

  private static final int ID_LENGTH = 5;
  private static final long KEPT_NANOS = TimeUnit.SECONDS.toNanos(KEPT_SECONDS);

  private final LongSupplier nanos;
  private final RandomGenerator random;
  private final Runnable onRequest;

  @GuardedBy("this")
  private final Map<CallKey, Entry> entries = new LinkedHashMap<>();

  /** The calls that one confirmation is about. */
  private record CallKey(
      String caller, String behalf, String rule, String robot, String object, String method) {

    static CallKey of(AccessRequest request, PolicyRule rule) {
      return new CallKey(
          CallRateLimiter.principal(request),
          request.caller().behalf().map(Behalf::toString).orElse(""),
          rule.name(),
          request.robot(),
          request.object(),
          request.methodName());
    }
  }

  private static final class Entry {
    final PendingConfirmation request;
    Answer answer = Answer.NONE;
    long end; // of the wait, or of the answer

    Entry(PendingConfirmation request) {
      this.request = request;
      this.end = request.end();
    }
  }

  /**
   * A request that waits.
   *
   * @param id by which an operator answers it: random characters, so that it never means another
   *     one
   * @param rule name of the rule that obliges to it
   * @param end when it is dropped, by the monotonic clock, in nanoseconds
   */
  public record PendingConfirmation(String id, AccessRequest request, String rule, long end) {}

  /**
   * @param nanos a monotonic clock in nanoseconds
   * @param random for the IDs of requests
   * @param onRequest called after each repeated or new request that waits, on the thread of the
   *     call; it returns at once
   */
  public ConfirmationRequests(LongSupplier nanos, RandomGenerator random, Runnable onRequest) {
    this.nanos = nanos;
    this.random = random;
    this.onRequest = onRequest;
  }

  @Override
  public Answer ask(AccessRequest request, PolicyRule rule) {
    Answer answer = answered(request, rule);
    if (answer == Answer.NONE) {
      onRequest.run();
    }
    return answer;
  }

  private synchronized Answer answered(AccessRequest request, PolicyRule rule) {
    dropEnded();
    CallKey key = CallKey.of(request, rule);
    @Nullable Entry known = entries.get(key);
    if (known != null) {
      return known.answer;
    }
    long ofCaller =
        entries.keySet().stream().filter(each -> each.caller().equals(key.caller())).count();
    if (entries.size() < MAX_REQUESTS && ofCaller < MAX_OF_CALLER) {
      entries.put(
          key,
          new Entry(
              new PendingConfirmation(
                  newId(), request, rule.name(), nanos.getAsLong() + KEPT_NANOS)));
    }
    return Answer.NONE;
  }

  private String newId() {
    StringBuilder id = new StringBuilder();
    for (int i = 0; i < ID_LENGTH; i++) {
      id.append(ID_CHARACTERS.charAt(random.nextInt(ID_CHARACTERS.length())));
    }
    return id.toString();
  }

  @Override
  public synchronized boolean use(AccessRequest request, PolicyRule rule) {
    dropEnded();
    CallKey key = CallKey.of(request, rule);
    @Nullable Entry known = entries.get(key);
    if (known == null || known.answer != Answer.CONFIRMED) {
      return false;
    }
    entries.remove(key);
    return true;
  }

  @GuardedBy("this")
  private void dropEnded() {
    long now = nanos.getAsLong();
    entries.values().removeIf(each -> now - each.end >= 0);
  }

  /** The requests that wait, the oldest first. */
  public synchronized List<PendingConfirmation> pending() {
    dropEnded();
    List<PendingConfirmation> pending = new ArrayList<>();
    entries.values().stream()
        .filter(each -> each.answer == Answer.NONE)
        .forEach(each -> pending.add(each.request));
    return pending;
  }

  /**
   * Answers a request: the next such call is permitted once, or such calls are refused, for {@value
   * #KEPT_SECONDS} s.
   *
   * @return false if there is no such request any more
   */
  public synchronized boolean answer(String id, boolean isConfirmed) {
    dropEnded();
    for (Entry each : entries.values()) {
      if (each.request.id().equals(id) && each.answer == Answer.NONE) {
        each.answer = isConfirmed ? Answer.CONFIRMED : Answer.REFUSED;
        each.end = nanos.getAsLong() + KEPT_NANOS;
        return true;
      }
    }
    return false;
  }
}
