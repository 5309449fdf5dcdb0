package org.dfra.attack.local;

import java.io.PrintStream;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.util.List;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import org.dfra.benchmarks.attack.StrangersGroup;
import org.dfra.benchmarks.task.Task;
import org.dfra.river.call.Endpoints;

/**
 * Has phoenix run a program of the attacker's, as phoenix's user: it registers a group with a class
 * path of its own, under each of the identities that phoenix might have, and activates an object in
 * it.
 *
 * <p>For each identity it prints {@code answered} or {@code silent}, whether phoenix answers under
 * it, and {@code registered} or {@code refused}, with why.
 */
public final class RegisterOwnGroup implements Task {

  /**
   * Registers.
   *
   * @param args phoenix's port at 127.0.0.1, a folder of the attacker's, the file that its program
   *     is to make, and the identities
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    StrangersGroup group =
        new StrangersGroup(
            Endpoints.tcpClient("127.0.0.1", Integer.parseInt(args[0])),
            Path.of(args[1]),
            Path.of(args[2]));
    for (String each : List.of(args).subList(3, args.length)) {
      Uuid identity = UuidFactory.create(each);
      try {
        out.println("answered " + group.groups(identity) + " groups");
      } catch (Exception e) { // whatever stops it is its outcome, here and below
        out.println("silent " + line(e));
      }
      register(group, identity, out);
    }
    out.println("done");
  }

  private static void register(StrangersGroup group, Uuid identity, PrintStream out) {
    try {
      ActivationGroupID registered = group.register(identity);
      out.println("registered");
      activate(group, registered, identity, out);
    } catch (Exception e) {
      out.println("refused " + line(e));
    }
  }

  private static void activate(
      StrangersGroup group, ActivationGroupID registered, Uuid identity, PrintStream out) {
    try {
      out.println("activated " + group.activate(registered, identity));
    } catch (Exception e) {
      out.println("ran " + line(e));
    }
  }

  private static String line(Exception e) {
    return e.toString().replaceAll("\\s+", " ");
  }
}
