package org.dfra.river.phoenix;

import java.io.EOFException;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import net.jini.activation.ActivationGroup;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.GroupCodebasePublisher;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.phoenix.host.PrintableOutputStream;
import org.dfra.river.phoenix.host.ProcessLock;
import org.dfra.river.phoenix.host.RotatingFileOutputStream;
import org.dfra.river.phoenix.host.UncaughtExceptionLogger;
import org.dfra.river.security.SecureProcess;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;
import org.slf4j.LoggerFactory;
import org.slf4j.bridge.SLF4JBridgeHandler;

/**
 * The virtual machine of one group. Phoenix starts it and sends it its group on standard input. It
 * receives no message if it dies: the daemon detects the exit of its process.
 */
final class GroupVm {

  /** Exit code if the daemon died before it sent the group. */
  static final int EXIT_NO_GROUP = 10;

  /** Exit code if another virtual machine still owns the group. */
  static final int EXIT_LOCKED = 11;

  /** Exit code if the group could not be created or was refused. */
  static final int EXIT_REFUSED = 12;

  private static final long OUTPUT_LIMIT = 4 << 20;
  private static final int OUTPUTS_KEPT = 4;

  private static volatile long incarnation;

  private GroupVm() {}

  /** The number given to this process at its start; 0 if it belongs to no group. */
  static long incarnation() {
    return incarnation;
  }

  /** Waits for its group on standard input, acquires its lock, and creates the group. */
  public static void main(String[] args) {
    SerialFilters.install();
    try {
      TrustedCode.install();
      ObjectInputStream in = new ObjectInputStream(System.in);
      ActivationGroupID id = (ActivationGroupID) in.readObject();
      ActivationGroupDesc desc = (ActivationGroupDesc) in.readObject();
      incarnation = in.readLong();
      in.close();
      redirectOutput();
      own(Path.of(System.getProperty(GroupProcess.LOCK_PROPERTY)));
      SecureProcess.Installed unused =
          SecureProcess.installFromProperty(System.getProperty(Phoenix.GROUP_NAME, "group"));
      GroupCodebasePublisher.begin();
      ActivationGroup.createGroup(id, desc, incarnation);
    } catch (EOFException e) {
      end(EXIT_NO_GROUP, "Phoenix ended before it sent the description of the group.");
    } catch (IOException e) {
      end(EXIT_LOCKED, String.valueOf(e.getMessage()));
    } catch (IllegalStateException e) {
      end(EXIT_REFUSED, "The group cannot be created: " + e.getMessage());
    } catch (ActivationException e) {
      end(EXIT_REFUSED, "The group cannot be created: " + e.getMessage() + cause(e));
    } catch (ClassNotFoundException e) {
      end(
          EXIT_REFUSED,
          "The group's class path lacks " + e.getMessage() + "; correct its options.");
    } catch (RuntimeException | LinkageError e) {
      LoggerFactory.getLogger(GroupVm.class).error("The group cannot be created.", e);
      end(EXIT_REFUSED, "The group cannot be created: " + e);
    }
  }

  /** Acquires the lock for the life of the process; there is no method to release it. */
  @SuppressWarnings("CheckReturnValue")
  private static void own(Path lockFile) throws IOException {
    Ownership.lock = ProcessLock.acquire(lockFile, "this group");
  }

  /**
   * Keeps the lock's channel reachable: a garbage-collected channel is closed and loses the lock.
   */
  private static final class Ownership {
    @SuppressWarnings("unused")
    private static @Nullable ProcessLock lock;
  }

  private static void redirectOutput() throws IOException {
    PrintStream out =
        new PrintStream(
            new PrintableOutputStream(
                new RotatingFileOutputStream(
                    Path.of(System.getProperty(GroupProcess.OUTPUT_PROPERTY)),
                    OUTPUT_LIMIT,
                    OUTPUTS_KEPT)),
            true,
            StandardCharsets.UTF_8);
    System.setOut(out);
    System.setErr(out);
    SLF4JBridgeHandler.removeHandlersForRootLogger();
    SLF4JBridgeHandler.install();
    UncaughtExceptionLogger.install();
  }

  private static String cause(Throwable e) {
    return e.getCause() == null || String.valueOf(e.getMessage()).contains("nested exception")
        ? ""
        : ": " + e.getCause();
  }

  private static void end(int code, String reason) {
    System.err.println(PrintableText.line(reason));
    Runtime.getRuntime().halt(code);
  }
}
