package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.UnknownHostException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.UnknownObjectException;
import java.util.List;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.security.proxytrust.TrustEquivalence;
import org.junit.jupiter.api.Test;

/** What a proxy does when its object is dead, and what it must not do. */
class ResurrectingHandlerTest extends ResurrectionFixture {

  @Test
  void livingObjectIsCalledAndNobodyElseIsAsked() throws Exception {
    assertThat(proxy(live("alive")).read()).isEqualTo("alive");
    assertThat(id.asked).isEmpty();
  }

  @Test
  void objectThatIsCertainlyNotThereIsBroughtBackAndForcedTheSecondTime() throws Exception {
    for (RemoteException dead :
        List.of(
            new NoSuchObjectException("x"),
            new ConnectException("x"),
            new ConnectIOException("x"),
            new UnknownHostException("x"))) {
      id.asked.clear();
      id.bringsBack(live("dead too", dead), live("new"));
      assertThat(proxy(live("dead", dead)).change()).as("%s", dead).isEqualTo("new");
      assertThat(id.asked).as("force, %s", dead).containsExactly(false, true);
    }
  }

  @Test
  void thirdFailureReachesTheCaller() {
    ConnectException last = new ConnectException("third");
    id.bringsBack(live("b", new ConnectException("second")), live("c", last));
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> proxy(live("a", new ConnectException("first"))).read())
        .isSameAs(last);
    assertThat(id.asked).hasSize(2);
  }

  @Test
  void callThatBrokeOffIsRepeatedOnceIfThatDoesNoHarm() throws Exception {
    id.bringsBack(live("new"));
    assertThat(proxy(live("dying", new UnmarshalException("cut"))).read()).isEqualTo("new");

    id.bringsBack(live("dying too", new UnmarshalException("cut again")));
    assertThatExceptionOfType(UnmarshalException.class)
        .isThrownBy(() -> proxy(live("dying", new UnmarshalException("cut"))).read())
        .withMessage("cut again");
  }

  @Test
  void callThatBrokeOffIsNotRepeatedOtherwiseAndTheNextOneAsksAgain() throws Exception {
    Service service = proxy(live("dying", new UnmarshalException("cut")));
    assertThatExceptionOfType(UnmarshalException.class).isThrownBy(service::change);
    assertThat(id.asked).isEmpty();
    id.bringsBack(live("new"));
    assertThat(service.change()).isEqualTo("new");
    assertThat(id.asked).containsExactly(false);
  }

  @Test
  void callThatMetItsDeadlineOrWasInterruptedIsNeverRepeated() throws Exception {
    for (RemoteException end :
        List.of(
            new DeadlineExceededException("late"),
            new CallInterruptedException("read", true),
            new MarshalException("too big"))) {
      Service service = proxy(live("alive", end));
      assertThatExceptionOfType(end.getClass()).isThrownBy(service::read).isSameAs(end);
      assertThat(id.asked).as("activations after %s", end).isEmpty();
    }
  }

  @Test
  void failuresOfTheActivationAreReportedAsFailuresOfTheCall() {
    Service service = proxy(gone());
    id.activating =
        force -> {
          throw new UnknownObjectException("unregistered");
        };
    assertThatExceptionOfType(NoSuchObjectException.class)
        .isThrownBy(service::read)
        .withCauseInstanceOf(UnknownObjectException.class);
    id.activating =
        force -> {
          throw new ActivationException("its constructor failed");
        };
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withStackTraceContaining("its constructor failed");
    id.activating =
        force -> {
          throw new ConnectException("nobody there");
        };
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(service::read)
        .withMessageContaining("the activation system cannot be reached");
    id.activating =
        force -> {
          throw new DeadlineExceededException("no answer");
        };
    assertThatExceptionOfType(ConnectIOException.class)
        .isThrownBy(service::read)
        .withMessageContaining("the activation system did not answer");
  }

  @Test
  void objectThatComesBackAsAnotherIsRefused() {
    Service service = proxy(gone());
    id.activating = force -> ResurrectingExporter.proxy(new Id("another"), live("new"));
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withMessage("the object came back under another activation ID");
    id.activating = force -> live("bare");
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(service::read)
        .withMessageContaining("without a resurrecting proxy");
  }

  @Test
  void proxiesOfOneObjectAreEqualWhateverIsBehindThem() throws Exception {
    Service one = proxy(live("one"));
    Service other = proxy(live("other"));
    assertThat(one).isEqualTo(other).hasSameHashCodeAs(other);
    assertThat(one).isNotEqualTo(ResurrectingExporter.proxy(new Id("another"), live("one")));
    assertThat(one.equals(null)).isFalse();
    assertThat(one.toString()).contains("Service").contains("ResurrectingHandler");
    assertThat(((TrustEquivalence) one).checkTrustEquivalence(other)).isTrue();
    assertThat(((TrustEquivalence) one).checkTrustEquivalence("text")).isFalse();

    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(one);
    }
    Service read =
        (Service) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
    assertThat(read).isEqualTo(one).hasSameHashCodeAs(one);
    assertThat(read.read()).as("the copy still knows the live one").isEqualTo("one");
  }

  @Test
  void constrainedProxyStillResurrectsAndConstrainsWhatComesBack() throws Exception {
    InvocationConstraint integrity = Integrity.YES;
    MethodConstraints constraints =
        new BasicMethodConstraints(new InvocationConstraints(integrity, null));
    ConnectException dead = new ConnectException("dead");
    Service constrained =
        (Service) ((RemoteMethodControl) proxy(live("old", dead))).setConstraints(constraints);
    assertThat(((RemoteMethodControl) constrained).getConstraints()).isEqualTo(constraints);
    assertThat(constrained).isNotEqualTo(proxy(live("old")));
    id.bringsBack(live("new"));
    assertThat(constrained.change()).isEqualTo("new constrained");
    assertThat(id.asked).hasSize(1);
  }
}
