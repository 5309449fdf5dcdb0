package org.dfra.river.transport;

import java.io.IOException;
import net.jini.core.constraint.Confidentiality;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.jeri.ServerEndpoint;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Client and server are two robots of a team. */
class TlsTransportTest extends TransportContract {

  private static final TestIdentities TEAM = new TestIdentities(new TestTeam("field"));
  private static final ChannelIdentity ROBOT = TEAM.of(MemberRole.ROBOT, "atrv1");

  @Override
  boolean finishesCalls() {
    return true;
  }

  @Override
  ServerEndpoint serverEndpoint() {
    return RecordingServer.endpoint(ROBOT);
  }

  @Override
  InvocationConstraint unmetConstraint() {
    return Confidentiality.NO;
  }

  @Override
  Integrity integrity() {
    return Integrity.YES;
  }

  @Test
  void aCallIsAnsweredThoughItIsAbortedAfterItsEnd() throws IOException {
    assertAnsweredThoughInterruptedAndAborted();
  }
}
