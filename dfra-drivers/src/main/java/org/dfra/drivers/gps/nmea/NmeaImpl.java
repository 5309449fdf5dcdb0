package org.dfra.drivers.gps.nmea;

import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.GpsReceiverProtocol;
import org.dfra.drivers.gps.GpsReceiverType;
import org.dfra.drivers.gps.ReportingPeriod.FixedReportingPeriod;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * Any receiver that sends NMEA 0183: {@code RMC}, {@code GGA} or {@code GNS}, {@code VTG}, {@code
 * ZDA}, {@code GSA} and {@code GSV} of any talker. The driver sends nothing to it: it is configured
 * with its manufacturer's tool.
 *
 * <p>Parameter, besides those of every {@link GpsReceiverImpl}: {@code period}, seconds from one
 * position to the next, as configured in the receiver; default 1. It only determines the timeout.
 *
 * <p>A fix is 3-D where {@code GGA} has altitude and geoid separation, whose sum is the height
 * above the ellipsoid; without them its height is 0. An estimated position ({@code GGA}) is not a
 * fix. Speed and course are those of the last {@code RMC} or {@code VTG} for 2 s, and unknown (NaN)
 * after that. Until {@code RMC} or {@code ZDA} has been received there is no {@code time}, because
 * the date is missing.
 */
public final class NmeaImpl extends GpsReceiverImpl<NmeaImpl.Protocol> {

  private static final GpsReceiverType KIND =
      GpsReceiverType.of("NMEA 0183 receiver", 1.0 / 3600, 50, List.of(GpsReceiverType.SATELLITES));

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public NmeaImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  NmeaImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        KIND,
        FixedReportingPeriod.from(context.parameters()),
        listener -> new Protocol(context, listener),
        ticker,
        source);
  }

  /** Only receives. */
  static final class Protocol implements GpsReceiverProtocol {

    private final Listener listener;
    private final NmeaEpochAssembler epoch;
    private final NmeaParser parser = new NmeaParser(this::messageReceived);

    Protocol(ModuleContext context, Listener listener) {
      this.listener = listener;
      this.epoch = new NmeaEpochAssembler(context.clock(), listener::solutionReceived);
    }

    @Override
    public void opened(SerialLink link) {
      epoch.forget();
    }

    @Override
    public NmeaParser parser() {
      return parser;
    }

    private void messageReceived(NmeaSentence sentence) {
      if (sentence instanceof NmeaSentence.Malformed malformed) {
        listener.malformedReceived(malformed.talker() + malformed.type(), malformed.reason());
      } else if (epoch.take(sentence)) {
        listener.satellitesReceived(epoch.satellites());
      }
    }
  }
}
