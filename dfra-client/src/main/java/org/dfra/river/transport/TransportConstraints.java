package org.dfra.river.transport;

import java.security.Principal;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import net.jini.core.constraint.ClientAuthentication;
import net.jini.core.constraint.ClientMaxPrincipal;
import net.jini.core.constraint.ClientMaxPrincipalType;
import net.jini.core.constraint.ClientMinPrincipal;
import net.jini.core.constraint.ClientMinPrincipalType;
import net.jini.core.constraint.Confidentiality;
import net.jini.core.constraint.ConstraintAlternatives;
import net.jini.core.constraint.Delegation;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.ServerAuthentication;
import net.jini.core.constraint.ServerMinPrincipal;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.ssl.ConfidentialityStrength;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * The constraints of River that a connection meets. Without encryption: those that River's own TCP
 * meets. With it: integrity, confidentiality, and the authentication of both sides, as far as their
 * principals are known.
 */
final class TransportConstraints {

  private static final ServerEndpoint TCP = TcpServerEndpoint.getInstance("127.0.0.1", 0);

  private TransportConstraints() {}

  /** What is known of a side of a connection. */
  private enum Side {
    CLIENT,
    SERVER
  }

  /**
   * Checks them for a connection without encryption.
   *
   * @return those that remain for the layers above
   * @throws UnsupportedConstraintException if a required one cannot be met
   */
  static InvocationConstraints checkPlain(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    return constraints.isEmpty() ? constraints : TCP.checkConstraints(constraints);
  }

  /**
   * Checks them for encrypted connections.
   *
   * @param client principals of the client; null if they are not known yet
   * @param server principals of the server; null if they are not known yet
   * @return those that remain for the layers above: the integrity of code
   * @throws UnsupportedConstraintException if a required one cannot be met
   */
  static InvocationConstraints checkEncrypted(
      InvocationConstraints constraints,
      @Nullable Set<Principal> client,
      @Nullable Set<Principal> server)
      throws UnsupportedConstraintException {
    if (constraints.isEmpty()) {
      return constraints;
    }
    for (Object each : constraints.requirements()) {
      if (!isMet((InvocationConstraint) each, client, server)) {
        throw new UnsupportedConstraintException(
            "the connection does not meet "
                + each
                + "; its client is "
                + text(client, Side.CLIENT)
                + ", its server "
                + text(server, Side.SERVER));
      }
    }
    return integrity(constraints);
  }

  private static String text(@Nullable Set<Principal> principals, Side side) {
    if (principals == null) {
      return side == Side.CLIENT ? "any client" : "any server";
    }
    return principals.isEmpty() ? "not authenticated" : List.copyOf(principals).toString();
  }

  /** The integrity of code is the business of the invocation layer. */
  private static InvocationConstraints integrity(InvocationConstraints constraints) {
    boolean isRequired = constraints.requirements().contains(Integrity.YES);
    boolean isPreferred = constraints.preferences().contains(Integrity.YES);
    if (!isRequired && !isPreferred) {
      return InvocationConstraints.EMPTY;
    }
    return new InvocationConstraints(
        isRequired ? Integrity.YES : null, isRequired ? null : Integrity.YES);
  }

  private static boolean isMet(
      InvocationConstraint constraint,
      @Nullable Set<Principal> client,
      @Nullable Set<Principal> server) {
    if (constraint instanceof ConstraintAlternatives alternatives) {
      return any(
          alternatives.elements(), each -> isMet((InvocationConstraint) each, client, server));
    } else if (constraint == Integrity.YES
        || constraint == Confidentiality.YES
        || constraint == ConfidentialityStrength.STRONG
        || constraint == Delegation.NO) {
      return true;
    } else if (constraint == Integrity.NO
        || constraint == Confidentiality.NO
        || constraint == ConfidentialityStrength.WEAK
        || constraint == Delegation.YES) {
      return false;
    } else if (constraint == ClientAuthentication.YES) {
      return client == null || !client.isEmpty();
    } else if (constraint == ClientAuthentication.NO) {
      return client == null || client.isEmpty();
    } else if (constraint == ServerAuthentication.YES) {
      return server == null || !server.isEmpty();
    } else if (constraint == ServerAuthentication.NO) {
      return server == null || server.isEmpty();
    } else if (constraint instanceof ServerMinPrincipal wanted) {
      return server == null || server.containsAll(wanted.elements());
    } else {
      return isMetByClient(constraint, client);
    }
  }

  private static boolean isMetByClient(
      InvocationConstraint constraint, @Nullable Set<Principal> client) {
    if (constraint instanceof ClientMinPrincipal wanted) {
      return client == null || client.containsAll(wanted.elements());
    } else if (constraint instanceof ClientMaxPrincipal allowed) {
      return client == null || allowed.elements().containsAll(client);
    } else if (constraint instanceof ClientMinPrincipalType types) {
      return client == null
          || all(types.elements(), type -> any(client, ((Class<?>) type)::isInstance));
    } else if (constraint instanceof ClientMaxPrincipalType types) {
      return client == null
          || all(client, each -> any(types.elements(), type -> ((Class<?>) type).isInstance(each)));
    }
    return isMetByTcp(constraint); // such as the times of a connection
  }

  private static boolean isMetByTcp(InvocationConstraint constraint) {
    try {
      InvocationConstraints unused =
          TCP.checkConstraints(new InvocationConstraints(constraint, null));
      return true;
    } catch (UnsupportedConstraintException e) {
      return false;
    }
  }

  private static boolean any(Set<?> elements, Predicate<Object> test) {
    return elements.stream().anyMatch(test);
  }

  private static boolean all(Set<?> elements, Predicate<Object> test) {
    return elements.stream().allMatch(test);
  }
}
