package org.dfra.river.remote.effector;

import org.dfra.flow.effector.PanTiltCommand;
import org.dfra.flow.effector.PanTiltEffector;

/** What clients may call on the server of a pan-tilt unit. */
public interface RemotePanTiltEffector extends RemoteEffector<PanTiltCommand>, PanTiltEffector {}
