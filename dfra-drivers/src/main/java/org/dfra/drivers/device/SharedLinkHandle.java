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
import org.dfra.drivers.link.ReopeningLink;
import org.jspecify.annotations.Nullable;

/**
 * A module's handle on the {@link SharedDeviceLink} that it shares with others; a protocol extends
 * it.
 *
 * <p>Parameters that it publishes, for the whole link: {@code frames}, {@code dropped_bytes},
 * {@code malformed_frames}. Test: {@code link}; recovery: {@code reopen_link}.
 *
 * @param <M> interface through which the protocol notifies and queries the module
 * @param <S> the protocol's shared link
 */
public abstract class SharedLinkHandle<M extends SharedLinkClient, S extends SharedDeviceLink<M>>
    implements ReopeningLink {

  /** Maximum wait for an answer, or for the next unsolicited message. */
  public static final Duration ANSWER = Duration.ofSeconds(3);

  private final M client;
  private final Function<M, S> joining;
  private volatile @Nullable S joined; // null before start() and after close()

  /**
   * @param client the module
   * @param joining joins the shared link, and opens it for the first module
   */
  protected SharedLinkHandle(M client, Function<M, S> joining) {
    this.client = client;
    this.joining = joining;
  }

  /**
   * Declares the test, the recovery and the parameters of every module on a shared link, see above.
   */
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

  /** Declares a count of the whole link; 0 while the module does not run. */
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

  /** Joins the shared link; opens it for the first module. */
  @Override
  public final void start() {
    joined = joining.apply(client);
  }

  /** Leaves the shared link; closes it after the last module. */
  @Override
  public final void close() {
    @Nullable S now = joined;
    joined = null;
    if (now != null) {
      now.leave(client);
    }
  }

  /** The shared link; null before {@link #start} and after {@link #close}. */
  public final @Nullable S sharedLink() {
    return joined;
  }

  /**
   * A check of the shared link.
   *
   * @param <S> the protocol's shared link
   */
  public interface LinkCheck<S> {
    DiagnosticFinding run(S shared) throws Exception;
  }

  /** Runs the check if the module runs. */
  protected final DiagnosticFinding runOnLink(LinkCheck<S> check) throws Exception {
    @Nullable S now = joined;
    return now == null
        ? new DiagnosticFinding(false, "the module has not been started, or has ended")
        : check.run(now);
  }

  /** Runs the check if the module runs and the link is open. */
  public final DiagnosticFinding runOnOpenLink(LinkCheck<S> check) throws Exception {
    return runOnLink(
        each -> {
          DiagnosticFinding link = each.deviceLink().link();
          return link.passed() ? check.run(each) : link;
        });
  }

  /**
   * A test that passes when the next event arrives.
   *
   * @param event name of the event in the link's {@link DeviceLink#eventCounter}
   * @param name human-readable name of the event
   * @param timeout maximum wait; queried when the test begins
   * @param found makes the finding when it has arrived
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
