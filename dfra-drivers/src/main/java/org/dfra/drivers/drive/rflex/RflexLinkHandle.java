package org.dfra.drivers.drive.rflex;

import org.dfra.core.module.Diagnostics.DiagnosticProcedure;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.SharedLinkHandle;
import org.dfra.drivers.drive.rflex.RflexController.RflexClient;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * A module's handle on the {@link RflexController} that it shares with others.
 *
 * <p>Parameters that it reads: {@code link}, {@code reopen_initial_delay}, {@code
 * reopen_max_delay}; of the last two, the values of the first module that starts apply. For its
 * published parameters and diagnostics see {@link SharedLinkHandle}.
 */
final class RflexLinkHandle extends SharedLinkHandle<RflexClient, RflexController> {

  /**
   * @param source opens the link; null to use the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  RflexLinkHandle(
      RflexClient client,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(client, each -> RflexController.join(each, context, ticker, source));
    var unusedAddress = LinkSettings.address(context.parameters()); // reports invalid values now
    var unusedBackOff = LinkSettings.backOff(context.parameters());
  }

  /** The queue of frames to the controller; null before {@link #start} and after {@link #close}. */
  @Nullable RflexOutbox outbox() {
    @Nullable RflexController now = sharedLink();
    return now == null ? null : now.outbox();
  }

  /**
   * A test that passes when the next event arrives.
   *
   * @param event name of the event
   * @param found makes the finding when it has arrived
   */
  DiagnosticProcedure arrivalCheck(String event, DiagnosticProcedure found) {
    return arrivalCheck(event, event, () -> ANSWER, found);
  }
}
