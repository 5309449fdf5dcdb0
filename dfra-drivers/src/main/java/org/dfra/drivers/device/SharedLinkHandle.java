package org.dfra.drivers.device;

import java.time.Duration;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.Diagnostics.DiagnosticProcedure;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.frame.StreamCounts;
import org.jspecify.annotations.Nullable;

/**
 * A module's end of the {@link SharedDeviceLink} that it shares with others; a protocol extends it.
 *
 * <p>Parameters that it shows, of all that shares the link: {@code frames}, {@code dropped_bytes},
 * {@code malformed_frames}. Test: {@code link}; recovery: {@code reopen_link}.
 *
 * @param <M> what the protocol tells the module and asks of it
 * @param <S> the protocol's line
 */
public abstract class SharedLinkHandle<M extends SharedLinkClient, S extends SharedDeviceLink<M>> {

  /** Longest wait for an answer, or for the next that comes by itself. */
  public static final Duration ANSWER = Duration.ofSeconds(3);

  private final M client;
  private final Function<M, S> joining;
  private volatile @Nullable S joined; // null before start() and after close()

  /**
   * @param client the module
   * @param joining joins the others, or opens the link if there are none
   */
  protected SharedLinkHandle(M client, Function<M, S> joining) {
    this.client = client;
    this.joining = joining;
  }

  /** Declares what every module behind a shared link has, see above. */
  public void declareIn(Diagnostics examinations, ParameterTable table) {
    examinations.addTest("link", () -> runOnLink(each -> each.deviceLink().link()));
    examinations.addRecovery(
        "reopen_link", () -> runOnLink(each -> each.deviceLink().reopenLink()));
    DeviceLink.showCounts(
        table,
        () -> {
          @Nullable S now = joined;
          return now == null ? StreamCounts.ZERO : now.deviceLink().counts();
        });
  }

  /** Declares a number that is counted for all that shares the link; 0 while it does not run. */
  protected final void show(
      ParameterTable table, String name, String meaning, ToLongFunction<S> count) {
    table.declareReadOnly(
        name,
        meaning,
        () -> {
          @Nullable S now = joined;
          return Long.toString(now == null ? 0 : count.applyAsLong(now));
        });
  }

  /** Joins the others; opens the link if there are none. */
  public final void start() {
    joined = joining.apply(client);
  }

  /** Leaves the others; the link is closed if there are none. */
  public final void close() {
    @Nullable S now = joined;
    joined = null;
    if (now != null) {
      now.leave(client);
    }
  }

  /** What it shares; null before {@link #start} and after {@link #close}. */
  public final @Nullable S sharedLink() {
    return joined;
  }

  /**
   * A check of what is shared.
   *
   * @param <S> the protocol's line
   */
  public interface LinkCheck<S> {
    DiagnosticFinding run(S shared) throws Exception;
  }

  /** Does it, where the module runs. */
  protected final DiagnosticFinding runOnLink(LinkCheck<S> check) throws Exception {
    @Nullable S now = joined;
    return now == null
        ? new DiagnosticFinding(false, "the module has not been started, or has ended")
        : check.run(now);
  }

  /** Does it, where the module runs and the link is open. */
  public final DiagnosticFinding runOnOpenLink(LinkCheck<S> check) throws Exception {
    return runOnLink(
        each -> {
          DiagnosticFinding link = each.deviceLink().link();
          return link.passed() ? check.run(each) : link;
        });
  }

  /**
   * The check whether another one comes.
   *
   * @param event is counted by the line's {@link DeviceLink#eventCounter}
   * @param name what it is, for people
   * @param timeout longest wait for it; asked when the check begins
   * @param found tells what is found when it has come
   */
  public final DiagnosticProcedure arrivalCheck(
      String event, String name, Supplier<Duration> timeout, DiagnosticProcedure found) {
    return () ->
        runOnOpenLink(
            each -> {
              Duration longest = timeout.get();
              long before = each.deviceLink().eventCounter().total(event);
              return each.deviceLink().eventCounter().await(event, before, longest)
                  ? found.run()
                  : new DiagnosticFinding(
                      false, "no " + name + " has come within " + LatestReading.seconds(longest));
            });
  }
}
