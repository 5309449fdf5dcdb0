package org.dfra.drivers.device;

import java.time.Duration;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Check;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.frame.StreamCounts;
import org.jspecify.annotations.Nullable;

/**
 * A module's end of the {@link SharedLine} that it shares with others; a protocol extends it.
 *
 * <p>Parameters that it shows, of all that shares the link: {@code frames}, {@code dropped_bytes},
 * {@code malformed_frames}. Test: {@code link}; recovery: {@code reopen_link}.
 *
 * @param <M> what the protocol tells the module and asks of it
 * @param <S> the protocol's line
 */
public abstract class SharedPort<M extends LineMember, S extends SharedLine<M>> {

  /** Longest wait for an answer, or for the next that comes by itself. */
  public static final Duration ANSWER = Duration.ofSeconds(3);

  private final M member;
  private final Function<M, S> joining;
  private volatile @Nullable S joined; // null before start() and after close()

  /**
   * @param member the module
   * @param joining joins the others, or opens the link if there are none
   */
  protected SharedPort(M member, Function<M, S> joining) {
    this.member = member;
    this.joining = joining;
  }

  /** Declares what every module behind a shared link has, see above. */
  public void declareIn(Examinations examinations, ParameterTable table) {
    examinations.test("link", () -> on(each -> each.line().link()));
    examinations.recovery("reopen_link", () -> on(each -> each.line().reopenLink()));
    DeviceLine.showCounts(
        table,
        () -> {
          @Nullable S now = joined;
          return now == null ? StreamCounts.ZERO : now.line().counts();
        });
  }

  /** Declares a number that is counted for all that shares the link; 0 while it does not run. */
  protected final void show(
      ParameterTable table, String name, String meaning, ToLongFunction<S> count) {
    table.show(
        name,
        meaning,
        () -> {
          @Nullable S now = joined;
          return Long.toString(now == null ? 0 : count.applyAsLong(now));
        });
  }

  /** Joins the others; opens the link if there are none. */
  public final void start() {
    joined = joining.apply(member);
  }

  /** Leaves the others; the link is closed if there are none. */
  public final void close() {
    @Nullable S now = joined;
    joined = null;
    if (now != null) {
      now.leave(member);
    }
  }

  /** What it shares; null before {@link #start} and after {@link #close}. */
  public final @Nullable S joined() {
    return joined;
  }

  /**
   * A check of what is shared.
   *
   * @param <S> the protocol's line
   */
  public interface LineCheck<S> {
    Finding run(S shared) throws Exception;
  }

  /** Does it, where the module runs. */
  protected final Finding on(LineCheck<S> check) throws Exception {
    @Nullable S now = joined;
    return now == null
        ? new Finding(false, "the module has not been started, or has ended")
        : check.run(now);
  }

  /** Does it, where the module runs and the link is open. */
  public final Finding onOpen(LineCheck<S> check) throws Exception {
    return on(
        each -> {
          Finding link = each.line().link();
          return link.passed() ? check.run(each) : link;
        });
  }

  /**
   * The check whether another one comes.
   *
   * @param what is counted by the line's {@link DeviceLine#heard}
   * @param name what it is, for people
   * @param patience longest wait for it; asked when the check begins
   * @param found tells what is found when it has come
   */
  public final Check next(String what, String name, Supplier<Duration> patience, Check found) {
    return () ->
        onOpen(
            each -> {
              Duration longest = patience.get();
              long before = each.line().heard().sofar(what);
              return each.line().heard().await(what, before, longest)
                  ? found.run()
                  : new Finding(
                      false, "no " + name + " has come within " + LatestReading.seconds(longest));
            });
  }
}
