package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.rmi.AccessException;
import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;

/**
 * Finds the phoenix of a host without a registry: its port is known, and its identity is in the
 * folder of its journal. So only phoenix's user and root can find it.
 */
public final class PhoenixLocator {

  private PhoenixLocator() {}

  /**
   * Returns a proxy of a host's activation system. Sends nothing before its first call.
   *
   * @param host where phoenix runs; it answers registrations only to callers on that host
   * @param port its TCP port
   * @param journal folder of its journal
   * @param deadline the longest wait for each answer
   * @return the proxy; it also implements {@link PhoenixAdmin}
   * @throws ConnectException if no phoenix was ever started with that folder
   * @throws AccessException if this user may not read its identity
   */
  public static ActivationSystem system(String host, int port, Path journal, Duration deadline)
      throws RemoteException {
    return (ActivationSystem)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient(host, port), identities(port, journal).system(), false),
            deadline,
            PhoenixLocator.class.getClassLoader(),
            ActivationSystem.class,
            PhoenixAdmin.class,
            ReadinessMonitor.class,
            RemoteMethodControl.class,
            TrustEquivalence.class);
  }

  /**
   * The exceptions get no cause: a remote exception with a cause has a message of several lines.
   */
  private static SecretIdentities identities(int port, Path journal) throws RemoteException {
    Path file = journal.resolve(PhoenixIdentities.FILE);
    try {
      return SecretIdentities.read(file);
    } catch (NoSuchFileException e) {
      throw new ConnectException("no phoenix was started with " + journal + " yet");
    } catch (AccessDeniedException e) {
      throw new AccessException(
          "the phoenix on port "
              + port
              + " belongs to user "
              + PrivateFiles.ownerName(file)
              + "; its identity file "
              + file
              + " cannot be read; run the command as that user");
    } catch (IOException e) {
      throw new AccessException(String.valueOf(e.getMessage()));
    }
  }
}
