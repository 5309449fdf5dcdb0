package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.core.config.RobotXml;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.entry.Entries;
import org.dfra.sim.world.file.WorldXml;

/**
 * Gives the XML parsers a robot and a world whose elements are nested 200 000 deep, and measures
 * the CPU time until each is rejected. No XML is read from the network, so this attack reads the
 * files as {@code ./dfra up} and {@code ./dfra sim run} do, in its own process on the attacker's
 * core.
 *
 * <p>At the end it registers an effector whose attributes report an emergency stop by a requester
 * with U+009B in the name, which starts a terminal control sequence, and lists it as an operator
 * does.
 */
public final class NestedXml extends OperatorVisibleAttack {

  private static final int DEPTH = 200_000;
  private static final double MOST_CPU = 1; // s for each file
  private static final long LEASE_MILLIS = 30_000;
  private static final int MOST_LISTINGS = 5;
  private static final String ROBOT = "noted";
  private static final String REQUESTER = "\u009b7m operator";
  private static final String SHOWN = "\\u009b7m"; // of the name, made printable

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final Random random = new Random(67); // no other task registers under its service IDs
  private final ServiceID effector = new ServiceID(random.nextLong(), random.nextLong());
  private Path robot = Path.of("");
  private Path world = Path.of("");
  private long longest; // nanoseconds of CPU time
  private int accepted;

  /** Called by {@code TaskMain} by reflection. */
  public NestedXml() {}

  /** Valid files are read first, so that classes are loaded, as in a robot. */
  @Override
  protected void prepare(Target target) throws IOException {
    var unused = WorldXml.read(HonestRobot.WORLD);
    var unusedEither = DemoRobot.describe(HonestRobot.XML, HonestRobot.NAME, Map.of());
    super.prepare(target);
    Path folder = target.folder();
    robot =
        Files.writeString(
            folder.resolve("robot.xml"),
            nested("<robot xmlns=\"urn:dfra:robot:1\" name=\"deep\">", "group", "</robot>"));
    world =
        Files.writeString(
            folder.resolve("world.xml"),
            nested(
                "<world xmlns=\"urn:dfra:world:1\" name=\"deep\" seed=\"1\">",
                "ground",
                "</world>"));
  }

  /** A document whose second line contains all nested elements. */
  private static String nested(String root, String element, String end) {
    return root
        + "\n"
        + ("<" + element + ">").repeat(DEPTH)
        + ("</" + element + ">").repeat(DEPTH)
        + "\n"
        + end
        + "\n";
  }

  @Override
  protected void attack(Target target) {
    read(() -> RobotXml.read(robot));
    read(() -> WorldXml.read(world));
  }

  private void read(Callable<Object> reader) {
    long before = threads.getCurrentThreadCpuTime();
    boolean isRead = attempt(reader) != null;
    longest = Math.max(longest, threads.getCurrentThreadCpuTime() - before);
    accepted += isRead ? 1 : 0;
  }

  @Override
  protected void end(Target target) throws Exception {
    ServiceRegistrar registrar = target.registrar();
    ServiceItem stopped =
        new ServiceItem(
            effector,
            HostileModule.proxy(),
            Entries.toEntries(HostileModule.stopped(ROBOT, REQUESTER)));
    // Beside other attacks a command may start after the lease has ended: then it lists nothing.
    for (int i = 0; i < MOST_LISTINGS && !terminal().shows(SHOWN); i++) {
      if (attempt(() -> registrar.register(stopped, LEASE_MILLIS)) == null) {
        return; // refused
      }
      terminal().run("module", "list");
      terminal().run("module", "info", ROBOT + "/drive");
    }
    terminal().requireShown(SHOWN);
  }

  @Override
  protected List<MeasuredValue> figures() {
    Stream<MeasuredValue> own =
        Stream.of(
            new MeasuredValue("CPU until nested XML is refused", longest / 1e9, MOST_CPU, "s"),
            new MeasuredValue("files with nested XML that were accepted", accepted, 0, ""));
    return Stream.concat(own, terminal().figures().stream()).toList();
  }
}
