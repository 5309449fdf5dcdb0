package org.dfra.drivers.uav.mavlink;

import java.util.List;
import java.util.Map;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.BatteryStatus;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.SystemStatus;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A battery of an unmanned aerial vehicle, as its autopilot measures it: {@code BATTERY_STATUS},
 * and {@code SYS_STATUS} for the first battery of an autopilot that does not send {@code
 * BATTERY_STATUS}.
 *
 * <p>Parameters, besides those of {@link MavlinkSensorImpl}: {@code battery}, its number, 0 to 255;
 * default 0, the first.
 *
 * <p>The voltage is the sum of the reported cells. The autopilot determines the remaining charge:
 * from the current where that is measured, else estimated from the voltage, which the reading
 * indicates.
 *
 * <p>Precondition: the voltage that MAVLink can represent in one number, 0 to 65 V.
 */
public final class MavlinkBatteryImpl extends MavlinkSensorImpl<BatteryState>
    implements BatterySensor {

  private static final List<Precondition> PRECONDITIONS =
      List.of(new Precondition("voltage of the battery", 0, 65, "V"));

  private final int battery;
  private final SensorAttributes sensor =
      new SensorAttributes("BatteryState", List.of("continuous"), 1.0 / 60, 20, null, List.of());
  private volatile boolean hasBatteryStatus; // whether BATTERY_STATUS has been received

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public MavlinkBatteryImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  MavlinkBatteryImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "battery of an autopilot, by MAVLink",
        "BATTERY_STATUS",
        List.of("BatteryState"),
        PRECONDITIONS,
        ticker,
        source);
    double number = settings().number("battery", 0, 0, 255);
    if (number != Math.rint(number)) {
      throw settings().fault("battery", "a whole number from 0 to 255", null);
    }
    this.battery = (int) number;
  }

  @Override
  Map<Integer, Double> messageRates(double rate) {
    return Map.of(MessageIds.BATTERY_STATUS, rate, MessageIds.SYS_STATUS, rate);
  }

  @Override
  void messageReceived(MavlinkMessage message) {
    if (message instanceof BatteryStatus reported && reported.id() == battery) {
      hasBatteryStatus = true;
      take(reported.voltage(), reported.current(), reported.remaining());
    } else if (message instanceof SystemStatus reported && battery == 0 && !hasBatteryStatus) {
      take(reported.voltage(), reported.current(), reported.remaining());
    }
  }

  private void take(
      @Nullable Double voltage, @Nullable Double current, @Nullable Double remaining) {
    if (voltage == null) {
      reportUnusable("the autopilot does not measure the voltage of battery " + battery);
      return;
    }
    BatteryState now =
        new BatteryState(
            clock().instant(), voltage, current, remaining, remaining != null && current == null);
    markDelivered(now);
    publish(now);
  }

  @Override
  void forget() {
    hasBatteryStatus = false;
  }

  /**
   * {@inheritDoc}
   *
   * @throws org.dfra.module.NotReadyException if no reading has been received yet, or the last one
   *     has expired
   */
  @Override
  public BatteryState battery() {
    return latest().get();
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return List.of(sensor);
  }
}
