package org.dfra.sim.time;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.DeviceImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.gpsd.GpsdImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;
import org.dfra.event.DeliveryPolicy;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.Cable;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.GpsdDevice;
import org.dfra.sim.device.gps.M12Device;
import org.dfra.sim.device.gps.NmeaDevice;
import org.dfra.sim.device.gps.UbxDevice;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;
import org.dfra.sim.physics.RangeInput;

/**
 * A robot with a receiver of every kind, a laser of 500 000 baud, and their real drivers, for a
 * minute or two. The seed decides where the receivers are, when they find their satellites, what
 * the laser sees, and when which cable is pulled, silent, bad or sound again and which device is
 * switched off and on. All that goes over the links and all that the drivers tell is written down,
 * with the instant.
 */
final class SeededRobot implements AutoCloseable {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");

  /** Long enough for each driver to open its link again and to get a reading. */
  private static final Duration SOUND_AT_LAST = Duration.ofSeconds(30);

  private static final int FAULTS_EACH = 4;

  private interface Maker {
    SerialDevice make(AntennaTrajectory path, int baud, Duration timeToFirstFix);
  }

  private final Random random;
  private final Duration end;
  private final Duration lastFault;
  private final LockStep time = new LockStep(BEGIN);
  private final StringBuilder record = new StringBuilder();
  private final List<SimPort> ports = new ArrayList<>();
  private final Map<String, DeviceImpl> drivers = new LinkedHashMap<>();
  private final Map<String, Supplier<String>> questions = new LinkedHashMap<>();
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);

  /**
   * One that is not started yet.
   *
   * @param length of its run, in simulated time; no cable is bad in the last 30 s
   */
  SeededRobot(long seed, Duration length) {
    random = new Random(seed);
    end = length;
    lastFault = length.minus(SOUND_AT_LAST);
    addReceiver("m12", 9600, M12Device::new, M12PlusImpl::new);
    addReceiver("nmea", 4800, NmeaDevice::new, NmeaImpl::new);
    addReceiver("ubx", 38_400, UbxDevice::new, UbxImpl::new);
    addReceiver("gpsd", 115_200, GpsdDevice::new, GpsdImpl::new);
    ModuleContext context = context("laser", Map.of("baud", "500000"));
    LmsImpl laser = new LmsImpl(context);
    RangeInput view = view(random.nextLong());
    add("laser", laser, () -> new LmsDevice(view, LmsEmulatorSettings.factoryDefault()));
    questions.put("laser", () -> laser.scan() + " " + laser.scan().hashCode());
  }

  /** Runs it, by its seed and length; prints the digest of what was written down. */
  public static void main(String[] arguments) {
    long seed = Long.parseLong(arguments[0]);
    try (SeededRobot robot = new SeededRobot(seed, Duration.parse(arguments[1]))) {
      System.out.println(digest(robot.run()));
    }
  }

  static String digest(String record) {
    try {
      MessageDigest sha = MessageDigest.getInstance("SHA-256");
      return HexFormat.of().formatHex(sha.digest(record.getBytes(StandardCharsets.UTF_8)));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }

  private void addReceiver(
      String name, int baud, Maker maker, Function<ModuleContext, GpsReceiverImpl<?>> driver) {
    GpsReceiverImpl<?> made = driver.apply(context(name, Map.of()));
    add(name, made, () -> receiver(maker, baud));
    questions.put(name, () -> made.fix() + " " + made.time() + " " + made.satellites());
  }

  private void add(String name, DeviceImpl driver, Supplier<SerialDevice> devices) {
    SimPort port = new SimPort(name, devices.get(), time);
    port.start();
    ports.add(port);
    SimAddress real = new SimAddress(port.url(), name);
    time.simLinks()
        .add(name + " tapped", asked -> new TappedLink(real.open(time), what -> write(name, what)));
    drivers.put(name, driver);
    var unused = directory.add(driver);
    for (int i = 0; i < FAULTS_EACH; i++) {
      Duration when = Duration.ofMillis(random.nextInt((int) lastFault.toMillis()));
      int kind = random.nextInt(5);
      long garble = random.nextLong();
      SerialDevice fresh = devices.get();
      time.after(when.toNanos(), () -> disturb(name, port.cable(), kind, garble, fresh));
    }
    time.after(lastFault.toNanos(), port.cable()::restore);
  }

  private SerialDevice receiver(Maker maker, int baud) {
    GeoPosition place = new GeoPosition(52 + random.nextDouble(), random.nextDouble() - 7, 55);
    double north = random.nextDouble() * 4 - 2;
    return maker.make(
        AntennaTrajectory.constantVelocity(place, BEGIN, north, random.nextDouble()),
        baud,
        Duration.ofMillis(random.nextInt(8000)));
  }

  private static RangeInput view(long seed) {
    Random noise = new Random(seed);
    return (when, first, step, longest, distances) -> {
      for (int i = 0; i < distances.length; i++) {
        distances[i] = 3 + 0.01 * noise.nextGaussian();
      }
    };
  }

  private void disturb(String name, Cable cable, int kind, long seed, SerialDevice fresh) {
    write(name, "fault " + kind);
    switch (kind) {
      case 0 -> cable.unplug();
      case 1 -> cable.mute();
      case 2 -> cable.corruptBytes(seed, 0.01);
      case 3 -> cable.restore();
      default -> cable.replace(fresh);
    }
  }

  private ModuleContext context(String name, Map<String, String> parameters) {
    Map<String, String> all = new HashMap<>(parameters);
    all.put("link", "sim:" + name + " tapped");
    return new ModuleContext("robot", name, Parameters.of("robot/" + name, all), time);
  }

  private void write(String name, String what) {
    record.append(time.nanos()).append(' ').append(name).append(' ').append(what).append('\n');
  }

  /** The drivers, for threads that query them meanwhile. */
  List<DeviceImpl> drivers() {
    return List.copyOf(drivers.values());
  }

  /** Runs to the end; returns what was written down. */
  String run() {
    drivers.forEach(this::listen);
    var watch =
        directory.listen(
            ModuleQuery.of(GPSSensor.class),
            new DirectoryListener<GPSSensor>() {
              @Override
              public void matched(ModuleListing<GPSSensor> listing) {
                write(listing.name(), "listed " + listing.attributes());
              }

              @Override
              public void changed(ModuleListing<GPSSensor> last, ModuleListing<GPSSensor> next) {
                write(next.name(), "changed " + next.attributes());
              }
            });
    drivers.values().forEach(DeviceImpl::start);
    time.advance(Duration.ofSeconds(20));
    lease("m12");
    for (DeviceImpl driver : drivers.values()) {
      for (String test : driver.tests()) {
        Diagnosis found = driver.test(test); // moves the time on
        write(driver.identification().name(), found.toString());
      }
    }
    time.after(0, () -> drivers.get("m12").setParameter("period", "2"));
    while (time.instant().isBefore(BEGIN.plus(end))) {
      time.advance(Duration.ofMillis(250));
      questions.forEach((name, question) -> write(name, answer(question)));
    }
    drivers.forEach((name, driver) -> write(name, driver.history() + " " + driver.parameters()));
    return record.toString();
  }

  private void listen(String name, DeviceImpl driver) {
    var everything =
        driver.subscribe(
            delivery -> write(name, "delivered " + delivery), DeliveryPolicy.keepLast(100));
    var rarely =
        driver.subscribe(
            delivery -> write(name, "rarely delivered " + delivery),
            DeliveryPolicy.latestReading().withMaxRate(0.4));
  }

  /** One that is not renewed, so that the module notices its end. */
  private void lease(String name) {
    try {
      var unused = drivers.get(name).acquireLease(Duration.ofSeconds(10));
    } catch (LeaseRefusedException e) {
      throw new AssertionError(e);
    }
  }

  private static String answer(Supplier<String> question) {
    try {
      return question.get();
    } catch (NotReadyException e) {
      return String.valueOf(e.getMessage());
    }
  }

  @Override
  public void close() {
    directory.close();
    drivers.values().forEach(DeviceImpl::close);
    ports.forEach(SimPort::close);
  }

  /** Writes down what goes over a link. */
  private record TappedLink(SerialLink link, Consumer<String> tap) implements SerialLink {

    @Override
    public int read(byte[] buffer, int offset, int length, Duration timeout) {
      int count = link.read(buffer, offset, length, timeout);
      tap.accept("< " + count + " " + hex(buffer, offset, Math.max(0, count)));
      return count;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      tap.accept("> " + hex(bytes, 0, bytes.length));
      link.write(bytes);
    }

    private static String hex(byte[] bytes, int offset, int length) {
      return HexFormat.of().formatHex(bytes, offset, offset + length);
    }

    @Override
    public boolean isOpen() {
      return link.isOpen();
    }

    @Override
    public void close() {
      tap.accept("closed");
      link.close();
    }

    @Override
    public String toString() {
      return link.toString();
    }
  }
}
