package org.dfra.activation;

import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.UnknownGroupException;

/** A program whose groups are all refused; then its main ends, and its JVM has to. */
public final class RefusedGroupMain {

  private RefusedGroupMain() {}

  public static void main(String[] args) {
    TestDaemon daemon = new TestDaemon();
    daemon.refusal = new UnknownGroupException("unregistered");
    for (Class<?> group : new Class<?>[] {PlainGroup.FailingLate.class, PlainGroup.class}) {
      ActivationGroupDesc desc = new ActivationGroupDesc(group.getName(), null, null, null, null);
      try {
        ActivationGroup.createGroup(new ActivationGroupID(daemon), desc, 1);
      } catch (ActivationException e) {
        System.out.println("refused " + group.getSimpleName());
      }
      PlainGroup.FailingLate.failed = null; // as in a program, which cannot have it
    }
  }
}
