package org.dfra.hosts;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.ObjectOutputStream;
import java.nio.charset.StandardCharsets;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.io.MarshalOutputStream;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.dfra.testing.InteractiveProcess;

/**
 * What runs on a host besides its robot: two receivers and a client, which does what the lines of
 * its input say.
 */
final class HostClient implements AutoCloseable {

  private static final Pattern ADDRESS = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");

  private final String address = HostAddress.resolve(HostAddress.AUTO);
  private final MulticastRequests requests = new MulticastRequests(address);
  private final JiniModuleDirectory directory;
  private final Map<String, GPSSensor> used = new ConcurrentHashMap<>();
  private final Map<String, Subscription> subscriptions = new TreeMap<>();
  private final Map<String, Timing> changes = new ConcurrentHashMap<>();
  private final StallProbe probe = StallProbe.start();

  private HostClient(String group) throws IOException {
    this.directory = new JiniModuleDirectory(address, List.of(group), List.of());
  }

  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    try (M12Emulator front = receiver();
        M12Emulator rear = receiver();
        HostClient client = new HostClient(args[0])) {
      say("GPS_FRONT=" + front.url() + " GPS_REAR=" + rear.url());
      BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
      for (String line; (line = in.readLine()) != null; ) {
        String[] words = line.split(" ");
        say(client.answer(words[0], words.length > 1 ? words[1] : ""));
      }
    }
    System.exit(0);
  }

  private static M12Emulator receiver() throws IOException {
    M12Emulator receiver =
        new M12Emulator(
            M12EmulatorSettings.at(new GeoPosition(52.9, 6.9, 50)).withBaud(115_200), Instant::now);
    receiver.start();
    return receiver;
  }

  private String answer(String verb, String of) throws Exception {
    return switch (verb) {
      case "list" -> list();
      case "robots" -> directory.personas().stream().map(each -> each.robot()).toList().toString();
      case "requests" -> String.join(" ", requests.wanted());
      case "carried" -> carried(of);
      case "registered" -> registered(of);
      case "call" -> call(of);
      case "listen" -> listen(of);
      case "received" -> received(of);
      case "watch" -> watch(of);
      case "changed" -> changed(of);
      default -> throw new IllegalArgumentException(verb);
    };
  }

  /** Each module as {@code path=id/fresh} or {@code path=id/stale}. */
  private String list() {
    List<String> modules = new ArrayList<>();
    for (ModuleListing<GPSSensor> each : directory.find(ModuleQuery.of(GPSSensor.class))) {
      modules.add(each.path() + "=" + each.id() + "/" + (each.stale() ? "stale" : "fresh"));
    }
    Collections.sort(modules);
    return String.join(" ", modules);
  }

  /** Every address in what the lookup service at a host gives away: proxies and codebases. */
  private static String carried(String host) throws Exception {
    ServiceRegistrar registrar = new LookupLocator(host, 4160).getRegistrar();
    TreeSet<String> addresses = new TreeSet<>();
    for (ServiceItem item :
        registrar.lookup(new ServiceTemplate(null, null, null), Integer.MAX_VALUE).items) {
      Matcher matcher = ADDRESS.matcher(bytes(item.service));
      while (matcher.find()) {
        addresses.add(matcher.group());
      }
    }
    return String.join(" ", addresses);
  }

  /** How many modules the lookup service at a host holds. */
  private static String registered(String host) throws Exception {
    ServiceRegistrar registrar = new LookupLocator(host, 4160).getRegistrar();
    Class<?>[] modules = {GPSSensor.class};
    return Integer.toString(
        registrar.lookup(new ServiceTemplate(null, modules, null), Integer.MAX_VALUE).totalMatches);
  }

  /** An object as it is sent, with the places of its classes. */
  private static String bytes(Object service) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      out.writeObject(service);
    }
    return bytes.toString(StandardCharsets.ISO_8859_1);
  }

  /** A measurement as {@code took stalled load stolen}: nanoseconds, but for the load. */
  private static String written(Timing timing) {
    return timing.took().toNanos()
        + " "
        + timing.stalled().toNanos()
        + " "
        + timing.load()
        + " "
        + timing.stolen().toNanos();
  }

  /** Reads a receiver's position and says how long that took, and what came of it. */
  private String call(String path) {
    GPSSensor gps = module(path);
    StallProbe.Stopwatch began = probe.stopwatch();
    String outcome;
    try {
      outcome = gps.fix().position() == null ? "nothing" : "ok";
    } catch (RemoteException e) {
      outcome = e.getClass().getSimpleName();
    }
    return written(began.stop()) + " " + outcome;
  }

  /** From now on awaits that a subscription is interrupted, or listens again, and times that. */
  private String watch(String path) {
    Subscription subscription = subscriptions.get(path);
    boolean before = subscription.interruptedSince().isPresent();
    StallProbe.Stopwatch began = probe.stopwatch();
    changes.remove(path);
    Thread watcher =
        new Thread(
            () -> {
              while (subscription.isOpen()) {
                if (subscription.interruptedSince().isPresent() != before) {
                  changes.put(path, began.stop());
                  return;
                }
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(10));
              }
            },
            "watch of " + path);
    watcher.setDaemon(true);
    watcher.start();
    return path;
  }

  /** What {@code watch} has measured; {@code -} where nothing has changed yet. */
  private String changed(String path) {
    Timing change = changes.get(path);
    return change == null ? "-" : written(change);
  }

  private String listen(String path) throws RemoteException {
    subscriptions.put(path, module(path).subscribe(event -> {}, DeliveryPolicy.keepLast(10)));
    return path;
  }

  /** Events received and lost, and whether the subscription is interrupted. */
  private String received(String path) {
    Subscription subscription = subscriptions.get(path);
    return subscription.received()
        + " "
        + subscription.lost()
        + " "
        + (subscription.interruptedSince().isPresent() ? "interrupted" : "listening");
  }

  /** Found once and kept, as a client would. */
  private GPSSensor module(String path) {
    return used.computeIfAbsent(
        path,
        wanted ->
            directory.find(ModuleQuery.of(GPSSensor.class)).stream()
                .filter(each -> each.path().equals(wanted))
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("there is no " + wanted))
                .module());
  }

  private static void say(String line) {
    System.out.println(InteractiveProcess.RESPONSE_PREFIX + line);
  }

  @Override
  public void close() {
    subscriptions.values().forEach(Subscription::close);
    directory.close();
    requests.close();
    probe.close();
  }
}
