package org.dfra.drivers.drive.rflex;

import org.dfra.core.module.Diagnostics.DiagnosticProcedure;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.SharedLinkHandle;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * A module's end of the {@link RflexController} that it shares with others.
 *
 * <p>Parameters that it reads: {@code link}, {@code reopen_first}, {@code reopen_longest}; of the
 * last two those of the first module that starts count. What it shows and how it is examined: see
 * {@link SharedLinkHandle}.
 */
final class RflexLinkHandle extends SharedLinkHandle<RflexClient, RflexController> {

  /**
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  RflexLinkHandle(
      RflexClient client,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(client, each -> RflexController.join(each, context, ticker, source));
    var unusedAddress = LinkSettings.address(context.parameters()); // complain now, not later
    var unusedBackOff = LinkSettings.backOff(context.parameters());
  }

  /**
   * Where the controller is told something; null before {@link #start} and after {@link #close}.
   */
  @Nullable RflexOutbox outbox() {
    @Nullable RflexController now = sharedLink();
    return now == null ? null : now.outbox();
  }

  /**
   * The check whether another one comes.
   *
   * @param event is counted
   * @param found tells what is found when it has come
   */
  DiagnosticProcedure arrivalCheck(String event, DiagnosticProcedure found) {
    return arrivalCheck(event, event, () -> ANSWER, found);
  }
}
