package org.dfra.drivers.gps.m12;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.GpsReceiverType;
import org.dfra.drivers.gps.m12.M12Message.HeldPosition;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Motorola Oncore M12+ GPS receiver, and its eight-channel predecessors.
 *
 * <p>Parameters, besides those of every {@link GpsReceiverImpl}:
 *
 * <ul>
 *   <li>{@code period}: seconds from one position to the next, a whole number from 1 to 255;
 *       default 1; can be set while it runs
 *   <li>{@code idle_period}: the same while there are no clients any more, not less than {@code
 *       rate}; default 10; can be set while it runs
 *   <li>{@code positioning}: {@code position_3d} (default), {@code altitude_hold}, {@code hold} or
 *       {@code survey}; can be set while it runs
 *   <li>{@code position_message}: {@code full} (default) or {@code short}, for a slow line
 *   <li>read-only: {@code integrity}, the result of time RAIM; {@code held_position}; {@code
 *       utc_offset}
 * </ul>
 *
 * <p>Until the first client arrives the receiver works at {@code period}, so that it is ready for
 * that client. For tests and recoveries see {@link M12Diagnostics}.
 *
 * <p>Positions are the receiver's filtered ones, with the height above the ellipsoid; speed is over
 * ground.
 */
public final class M12PlusImpl extends GpsReceiverImpl<M12Protocol> {

  /** The receiver's rate is 1 Hz to one position in 255 s; user's guide, message @@Ha. */
  private static final GpsReceiverType KIND =
      new GpsReceiverType(
          "Motorola Oncore M12+ GPS receiver",
          1.0 / M12ReportingPeriod.LONGEST,
          1,
          new GpsReceiverAttributes(null, null, null, null, null, List.of("2D", "3D")),
          M12Diagnostics.PRECONDITIONS);

  private final M12ReportingPeriod rate;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public M12PlusImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /**
   * For tests: uses the given clock and source of links.
   *
   * @param source opens the link; null to use the parameter {@code link}
   */
  M12PlusImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    this(
        context,
        ticker,
        source,
        M12ReportingPeriod.from(context.parameters()),
        M12ReceiverSettings.from(context.parameters()));
  }

  private M12PlusImpl(
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source,
      M12ReportingPeriod rate,
      M12ReceiverSettings settings) {
    super(
        context,
        KIND,
        rate,
        listener -> new M12Protocol(rate, settings, context.clock(), ticker, listener),
        ticker,
        source);
    this.rate = rate;
    declareRates();
    declareState(settings);
    new M12Diagnostics(receiverDiagnostics(), protocol(), clock()).declareIn(diagnostics());
  }

  private void declareRates() {
    NumberRange seconds = NumberRange.isInteger(1, M12ReportingPeriod.LONGEST, "s");
    parameterTable()
        .declareNumber(
            "period",
            "from one position to the next",
            seconds,
            rate::working,
            value -> rate.setWorking((int) value));
    parameterTable()
        .declareNumber(
            "idle_period",
            "from one position to the next when the last client has gone",
            seconds,
            rate::idle,
            value -> rate.setIdle((int) value));
  }

  private void declareState(M12ReceiverSettings settings) {
    parameterTable()
        .declareText(
            "positioning",
            "what the receiver solves for: position_3d, altitude_hold, hold or survey",
            () -> settings.positioning().word(),
            settings::setPositioning);
    parameterTable()
        .declareReadOnly(
            "integrity",
            "what time RAIM found of the last solution",
            () -> protocol().timeRaim().map(TimeRaim::inWords).orElse("not reported"));
    parameterTable()
        .declareReadOnly(
            "held_position",
            "the position for position hold, degrees and metres above the ellipsoid",
            () -> protocol().held().map(M12PlusImpl::inWords).orElse("not reported"));
    parameterTable()
        .declareReadOnly(
            "utc_offset",
            "GPS time minus UTC, s",
            () ->
                protocol()
                    .utcOffset()
                    .map(reported -> reported.seconds() + "")
                    .orElse("not known"));
  }

  private static String inWords(HeldPosition held) {
    M12Position position = held.position();
    return String.format(
        Locale.ROOT,
        "%.7f %.7f %.2f",
        position.latitude(),
        position.longitude(),
        position.height());
  }

  @Override
  protected void onClientCount(int number) {
    rate.setIdleMode(number == 0);
  }

  /** The receiver's identification; empty until it is received. */
  public Optional<ReceiverIdentification> identified() {
    return protocol().identification();
  }
}
