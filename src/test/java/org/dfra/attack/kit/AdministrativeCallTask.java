package org.dfra.attack.kit;

import com.sun.jini.admin.DestroyAdmin;
import com.sun.jini.landlord.Landlord;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.UUID;
import java.util.concurrent.Callable;
import net.jini.admin.Administrable;
import net.jini.admin.JoinAdmin;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.id.UuidFactory;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.benchmarks.task.Task;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lease.LeaseStatus;
import org.dfra.module.LogLevel;
import org.dfra.river.remote.GrantedModuleLease;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.effector.RemoteDriveEffector;

/**
 * Everything that a program without a key can try with a robot's drive and registrar, from any
 * address of this computer, as a process of its own. A line of its input is an address and a verb;
 * each call is answered by a line with its name and its outcome: {@code done}, or the exception.
 */
public final class AdministrativeCallTask implements Task {

  /** What its answers end with. */
  public static final String END = "end";

  private PrintStream out = System.out;

  /** As every task is made. */
  public AdministrativeCallTask() {}

  /** Arguments: the registrar's host and port. */
  @Override
  public void run(String[] args, PrintStream to) throws Exception {
    out = to;
    out.println("ready");
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line; (line = in.readLine()) != null; ) {
      String[] words = line.split(" ");
      SourceSockets sockets = SourceSockets.from(words[0]);
      ServiceRegistrar registrar =
          SourceBoundProxies.registrar(args[0], Integer.parseInt(args[1]), sockets);
      switch (words[1]) {
        case "lease" -> leases(drive(registrar, sockets), sockets);
        case "module" -> module(drive(registrar, sockets), sockets);
        case "parameter" -> parameter(drive(registrar, sockets));
        case "end-module" -> endModule(drive(registrar, sockets), sockets);
        case "registrar" -> registrar(registrar, sockets);
        case "end-registrar" -> endRegistrar(registrar, sockets);
        case "stop" -> attempt("stop", () -> drive(registrar, sockets).emergencyStop("a stranger"));
        case "release" ->
            attempt("release", () -> drive(registrar, sockets).releaseEmergencyStop("a stranger"));
        default -> throw new IllegalArgumentException(line);
      }
      out.println(END);
    }
  }

  private static RemoteDriveEffector drive(ServiceRegistrar registrar, SourceSockets sockets)
      throws IOException {
    Object proxy =
        registrar.lookup(new ServiceTemplate(null, new Class<?>[] {DriveEffector.class}, null));
    return SourceBoundProxies.of(
        SourceBoundProxies.remote(
            Objects.requireNonNull(proxy, "no drive"), RemoteDriveEffector.class),
        sockets);
  }

  private void leases(RemoteDriveEffector drive, SourceSockets sockets) throws Exception {
    ModuleAdmin admin = SourceBoundProxies.of((ModuleAdmin) drive.getAdmin(), sockets);
    List<LeaseStatus> listed = admin.leases();
    out.println("listed " + listed.size());
    GrantedModuleLease own = (GrantedModuleLease) drive.acquireLease(Duration.ofSeconds(5));
    Landlord landlord =
        SourceBoundProxies.of(SourceBoundProxies.remote(own.lease(), Landlord.class), sockets);
    for (LeaseStatus each : listed) {
      UUID name = each.handle().value();
      attempt(
          "cancel",
          () -> {
            landlord.cancel(
                UuidFactory.create(name.getMostSignificantBits(), name.getLeastSignificantBits()));
            return "";
          });
      attempt("revoke", () -> admin.revoke(each.handle()));
    }
    own.close(); // so that the next one who lists leases does not see it
  }

  private void module(RemoteDriveEffector drive, SourceSockets sockets) throws Exception {
    ModuleAdmin admin = SourceBoundProxies.of((ModuleAdmin) drive.getAdmin(), sockets);
    parameter(drive);
    attempt("level", () -> call(() -> drive.setLogLevel(LogLevel.TRACE)));
    attempt("outputs", () -> call(() -> drive.setOutputs(List.of())));
    attempt("groups", () -> call(() -> admin.setLookupGroups(new String[] {"elsewhere"})));
  }

  private void parameter(RemoteDriveEffector drive) {
    attempt("parameter", () -> call(() -> drive.setParameter("max_speed", "0.2")));
  }

  private void endModule(RemoteDriveEffector drive, SourceSockets sockets) throws Exception {
    ModuleAdmin admin = SourceBoundProxies.of((ModuleAdmin) drive.getAdmin(), sockets);
    attempt("deactivate", () -> call(admin::deactivate));
    attempt("destroy", () -> call(admin::destroy));
  }

  private void registrar(ServiceRegistrar registrar, SourceSockets sockets) throws Exception {
    Object admin = SourceBoundProxies.of(((Administrable) registrar).getAdmin(), sockets);
    DiscoveryAdmin groups = (DiscoveryAdmin) admin;
    attempt("set groups", () -> call(() -> groups.setMemberGroups(new String[] {"elsewhere"})));
    attempt("add groups", () -> call(() -> groups.addMemberGroups(new String[] {"elsewhere"})));
    attempt("join", () -> call(() -> ((JoinAdmin) admin).addLookupGroups(new String[] {"b"})));
  }

  private void endRegistrar(ServiceRegistrar registrar, SourceSockets sockets) throws Exception {
    Object admin = SourceBoundProxies.of(((Administrable) registrar).getAdmin(), sockets);
    attempt("port", () -> call(() -> ((DiscoveryAdmin) admin).setUnicastPort(0)));
    attempt("destroy", () -> call(() -> ((DestroyAdmin) admin).destroy()));
  }

  private interface Body {
    void run() throws Exception;
  }

  private static Object call(Body body) throws Exception {
    body.run();
    return "";
  }

  private void attempt(String what, Callable<?> call) {
    String outcome;
    try {
      Object unused = call.call();
      outcome = "done";
    } catch (Exception e) { // whatever stops it is its outcome
      outcome = e.getClass().getSimpleName();
    }
    out.println(what + ": " + outcome);
  }
}
