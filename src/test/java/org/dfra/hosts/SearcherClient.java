package org.dfra.hosts;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;
import org.dfra.flow.perceptual.TeamTracker;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Incident;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.InteractiveProcess;
import org.dfra.testing.SerialCable;

/**
 * What runs on the host of a robot that searches, besides the robot: the ends of its serial cables
 * and a client, which does what the lines of its input say.
 */
final class SearcherClient implements AutoCloseable {

  private final JiniModuleDirectory directory;
  private final Map<String, Subscription> subscriptions = new TreeMap<>(); // by robot
  private final Map<String, RasterSearch> searches = new TreeMap<>(); // by robot

  private SearcherClient(String group) throws IOException {
    this.directory =
        new JiniModuleDirectory(HostAddress.resolve(HostAddress.AUTO), List.of(group), List.of());
  }

  /** Arguments: the team, and for each device {@code NAME=FILE} with the socket of its cable. */
  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    List<SerialCable> cables = new ArrayList<>();
    try (SearcherClient client = new SearcherClient(args[0])) {
      List<String> links = new ArrayList<>();
      for (int i = 1; i < args.length; i++) {
        String[] device = args[i].split("=");
        SerialCable cable = SerialCable.robotEnd(Path.of(device[1]));
        cables.add(cable);
        links.add(device[0] + "=" + cable.link());
      }
      say(String.join(" ", links));
      BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
      for (String line; (line = in.readLine()) != null; ) {
        String[] words = line.split(" ");
        say(client.answer(words));
      }
    } finally {
      for (SerialCable cable : cables) {
        cable.close();
      }
    }
    System.exit(0);
  }

  /**
   * What is to be said. A call that failed is reported as {@code failed: ...}, and so is a module
   * that has nothing fresh to give, as after a moment in which the computer did nothing else.
   */
  private String answer(String[] words) throws IOException {
    try {
      return answer(words[0], words.length > 1 ? words[1] : "", words);
    } catch (RemoteException | GoalRefusedException | NotReadyException e) {
      return "failed: " + e;
    }
  }

  private String answer(String verb, String robot, String[] words)
      throws RemoteException, GoalRefusedException {
    return switch (verb) {
      case "search" -> search(robot, words);
      case "list" -> list();
      case "ready" -> Integer.toString(ready(robot));
      case "progress" -> progress(robot);
      case "listen" -> listen(robot);
      case "received" -> received(robot);
      case "mate" -> teammate(robot);
      case "gaps" -> gaps(robot);
      default -> throw new IllegalArgumentException(verb);
    };
  }

  /** Each module of any robot as {@code path=id/fresh} or {@code path=id/stale}. */
  private String list() {
    return String.join(
        " ",
        directory.find(ModuleQuery.of(Module.class)).stream()
            .map(each -> each.path() + "=" + each.id() + "/" + (each.stale() ? "stale" : "fresh"))
            .sorted()
            .toList());
  }

  /** How many modules of a robot serve. */
  private int ready(String robot) {
    return (int)
        directory.find(ModuleQuery.of(Module.class).robot(robot)).stream()
            .filter(
                each ->
                    each.attributes(ModuleAttributes.class)
                        .filter(attributes -> attributes.state().serves())
                        .isPresent())
            .count();
  }

  /** How far a robot's search is, 0 to 1, and in which phase; asked of the robot. */
  private String progress(String robot) throws RemoteException {
    BehaviorStatus status = search(robot).status();
    return String.format(Locale.ROOT, "%.4f %s", status.completion(), status.phase());
  }

  /** Has a robot search a region, if it does not yet: {@code search ROBOT forth|back CORNER...}. */
  private String search(String robot, String[] words) throws RemoteException, GoalRefusedException {
    if (!search(robot).status().phase().isUnderWay()) {
      List<GeoPosition> corners = new ArrayList<>();
      for (int i = 3; i < words.length; i++) {
        String[] corner = words[i].split(",");
        corners.add(
            new GeoPosition(Double.parseDouble(corner[0]), Double.parseDouble(corner[1]), 0));
      }
      var unused = search(robot).pursue(new RasterGoal(corners, 2.5, 2, words[2].equals("back")));
    }
    return progress(robot);
  }

  private String listen(String robot) throws RemoteException {
    subscriptions.put(
        robot,
        search(robot)
            .subscribe(event -> {}, DeliveryPolicy.keepLast(10).withKinds(EventKind.READING)));
    return robot;
  }

  /**
   * Readings received and lost of a robot's search, and whether the subscription is interrupted.
   */
  private String received(String robot) {
    Subscription subscription = subscriptions.get(robot);
    return subscription.received()
        + " "
        + subscription.lost()
        + " "
        + (subscription.interruptedSince().isPresent() ? "interrupted" : "listening");
  }

  /** Found once and kept, as a client would. */
  private RasterSearch search(String robot) {
    return searches.computeIfAbsent(robot, wanted -> one(RasterSearch.class, wanted).module());
  }

  private <M extends Module> ModuleListing<M> one(Class<M> kind, String robot) {
    return directory.find(ModuleQuery.of(kind).robot(robot)).stream()
        .findFirst()
        .orElseThrow(() -> new IllegalStateException(robot + " has no " + kind.getSimpleName()));
  }

  /**
   * What a robot knows of the other: how far its clock is ahead, within what, seconds; metres to
   * it; what was missed; whether it is out of reach. Or {@code nothing}.
   */
  private String teammate(String robot) throws RemoteException {
    List<Teammate> teammates = one(TeamTracker.class, robot).module().team().teammates();
    if (teammates.size() != 1
        || teammates.get(0).clockOffset() == null
        || teammates.get(0).relativePosition() == null) {
      return "nothing: " + teammates;
    }
    Teammate teammate = teammates.get(0);
    return String.format(
        Locale.ROOT,
        "%.4f %.4f %.2f %d %s",
        teammate.clockOffset().seconds(),
        teammate.clockOffset().uncertaintySeconds(),
        teammate.relativePosition().distance(),
        teammate.missedReadings(),
        teammate.isOutOfReach() ? "lost" : "reachable");
  }

  /** Gaps in what a robot received from the other, by its history; {@code none} without a gap. */
  private String gaps(String robot) throws RemoteException {
    List<String> gaps =
        one(TeamTracker.class, robot).module().history().recent().stream()
            .filter(each -> each.kind() == Incident.Kind.GAP)
            .map(Incident::description)
            .toList();
    return gaps.isEmpty() ? "none" : String.join("; ", gaps);
  }

  private static void say(String line) {
    System.out.println(InteractiveProcess.RESPONSE_PREFIX + line);
  }

  @Override
  public void close() {
    subscriptions.values().forEach(Subscription::close);
    directory.close();
  }
}
