package org.dfra.drivers.drive.rflex;

import org.dfra.core.module.Examinations.Check;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.SharedPort;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * A module's end of the {@link RflexController} that it shares with others.
 *
 * <p>Parameters that it reads: {@code link}, {@code reopen_first}, {@code reopen_longest}; of the
 * last two those of the first module that starts count. What it shows and how it is examined: see
 * {@link SharedPort}.
 */
final class RflexPort extends SharedPort<RflexMember, RflexController> {

  /**
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  RflexPort(
      RflexMember member,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(member, each -> RflexController.join(each, context, ticker, source));
    var unusedAddress = LinkSettings.address(context.parameters()); // complain now, not later
    var unusedBackOff = LinkSettings.backOff(context.parameters());
  }

  /**
   * Where the controller is told something; null before {@link #start} and after {@link #close}.
   */
  @Nullable RflexOutbox outbox() {
    @Nullable RflexController now = joined();
    return now == null ? null : now.outbox();
  }

  /**
   * The check whether another one comes.
   *
   * @param what is counted
   * @param found tells what is found when it has come
   */
  Check next(String what, Check found) {
    return next(what, what, () -> ANSWER, found);
  }
}
