/** Attacks by listeners of remote events. */
package org.dfra.attack.event;
