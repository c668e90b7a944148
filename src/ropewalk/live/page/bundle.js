"use strict";(()=>{var Li=n=>[n[0],n[1],n[2]],$e=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Uo=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],En=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],ae=(n,t,e=1)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],Ze=(n,t)=>[n[0]*t,n[1]*t,n[2]*t],Ks=n=>Math.hypot(n[0],n[1],n[2]);function Wa(n,t=[0,0,1]){let e=Ks(n);return e>0?Ze(n,1/e):t}var H_=3,au=[["ArrowLeft","ArrowRight","ArrowUp","ArrowDown","Home","End"],["KeyA","KeyD","KeyW","KeyS","KeyQ","KeyE"],["KeyJ","KeyL","KeyI","KeyK","KeyU","KeyO"]],Xa=class{constructor(t,e,i){this.session=t,this.camera=e,this.shortcuts=i,this.held=new Set,this.moving=new Map,addEventListener("keydown",s=>this.press(s)),addEventListener("keyup",s=>this.lift(s.code)),addEventListener("blur",()=>this.releaseAll()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.releaseAll()}),document.addEventListener("click",G_),t.on("connection",()=>this.forget())}press(t){if(W_(t))return;if(t.ctrlKey||t.metaKey||t.altKey){!t.altKey&&!t.shiftKey&&t.key.toLowerCase()==="z"&&this.shortcuts.undo&&(t.preventDefault(),this.shortcuts.undo());return}let e=au.findIndex(s=>s.includes(t.code));if(e>=0&&this.anchor(e)!==null&&this.session.can("move")){if(t.preventDefault(),t.repeat||this.held.has(t.code))return;this.held.add(t.code),this.sendHand(e);return}let i=this.shortcuts[t.key.toLowerCase()];i&&(t.key===" "&&X_(t.target)||(t.preventDefault(),(!t.repeat||t.key===".")&&i()))}lift(t){this.held.delete(t)&&this.sendHand(au.findIndex(e=>e.includes(t)))}releaseAll(){this.held.clear();for(let t of[...this.moving.keys()])this.sendHand(t)}forget(){this.held.clear(),this.moving.clear()}anchor(t){let e=this.session.layout?.variants[0].anchors??[],i=this.session.frame?.parts[0];return e.filter((r,o)=>!i||i.anchors[10*o+9]>.5)[t]?.name??null}sendHand(t){let e=au[t].map(g=>this.held.has(g)?1:0),i=this.moving.get(t)??this.anchor(t);if(i===null)return;let[s,r,o,a,l,c]=e,{camera:d}=this,u=Ze(d.first,r-s);u=ae(u,d.up,o-a),u=ae(u,d.second,l-c);let h=Ks(u),f=h>0?Ze(u,H_/h):[0,0,0];h>0?this.moving.set(t,i):this.moving.delete(t),this.session.send({type:"move",anchor:i,velocity:f})}};function G_(n){let{target:t}=n;if(n.detail===0||!(t instanceof Element))return;t instanceof HTMLInputElement&&["range","checkbox"].includes(t.type)?t.blur():t.closest("button")?.blur()}function W_({target:n,code:t}){return n instanceof HTMLElement?n instanceof HTMLInputElement?n.type==="range"?/^(Arrow|Page|Home|End)/.test(t):!["checkbox","radio","button"].includes(n.type):n.isContentEditable||["SELECT","TEXTAREA"].includes(n.tagName):!1}function X_(n){return n instanceof HTMLElement&&n.closest("button, summary, [role=menuitem]")!==null}var $a=n=>new DataView(n).getUint32(4,!0),qf=n=>new DataView(n).getUint32(8,!0);function Nr(n,t){let e=new DataView(n);if(e.byteLength<48||e.getUint32(0,!0)!==1179670354)throw new Error("not a frame");if(e.getUint32(4,!0)!==t.layout)throw new Error("a frame of another layout");if(n.byteLength<t.bytes)throw new Error("a frame cut short");return{layout:t.layout,number:e.getUint32(8,!0),flags:e.getUint32(12,!0),time:e.getFloat64(16,!0),steps:e.getFloat64(24,!0),realtime:e.getFloat32(32,!0),speed:e.getFloat32(36,!0),load:e.getFloat32(40,!0),parts:t.variants.map((i,s)=>$_(n,t,i,s))}}function Yf(n){n.parts[0]?.scalars.buffer?.transfer?.(0)}function $_(n,t,e,i){let{offsets:s,nodes:r,anchors:o}=e,a=t.variants[i+1]?.offsets.scalars??t.bytes;return{scalars:new Float32Array(n,s.scalars,t.scalars.length),positions:new Float32Array(n,s.positions,3*r),tension:new Uint16Array(n,s.tension,r),speed:new Uint16Array(n,s.speed,r),seen:{leastTension:new Uint16Array(n,s.least_tension,r),greatestTension:new Uint16Array(n,s.greatest_tension,r),greatestSpeed:new Uint16Array(n,s.greatest_speed,r),leastHeight:new Uint16Array(n,s.least_height,r),greatestHeight:new Uint16Array(n,s.greatest_height,r),greatestForce:new Float32Array(n,s.greatest_force,o.length)},anchors:new Float32Array(n,s.anchors,10*o.length),grabs:new Float32Array(n,s.grabs,8*Math.floor((a-s.grabs)/32))}}function en(n,t,e){let i=n.scalars.indexOf(e);return i<0?NaN:t.scalars[i]}function Dr(n,t,e,i,s){let r=i===null?0:en(n,t,i);return r+e/65535*(en(n,t,s)-r)}var Oo=class{constructor(){this.low=0,this.high=1,this.fresh=!0}follow(t,e,i){if(!Number.isFinite(t)||!Number.isFinite(e))return;let s=t<-.01*e?t:0,r=Math.max(e,s+1e-9);if(this.fresh){[this.low,this.high,this.fresh]=[s,r,!1];return}let o=1-Math.exp(-i/4);this.high=r>this.high?r:this.high+o*(Math.max(r,1e-9)-this.high),this.low=s<this.low?s:this.low+o*(s-this.low)}},Zf=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],q_=new Set(["N","J","W","s","Hz","N/m","m","m/s","N s/m"]),Fr=n=>n==="1"?"":n.replace(/\^2/g,"²").replace(/\^3/g,"³");function Ne(n,t=""){if(n==null||Number.isNaN(n))return"–";if(!Number.isFinite(n))return n>0?"∞":"−∞";let e=t&&t!=="1"?` ${Fr(t)}`:"";if(n===0)return`0${e}`;let i=Math.abs(n);if(q_.has(t)&&(i>=1e4||i<.1)&&i>=1e-9){let s=t==="m"||t==="m/s"?1:1e10,[r,o]=Zf.find(([a])=>i>=a*.9995&&a<=s)??Zf[6];return`${Ie(n/r)} ${o}${t}`}return`${Ie(n)}${e}`}function Ie(n){let t=Math.abs(n);if(t>=1e5||t<.001){if(n===0)return"0";let[i,s]=n.toExponential(2).split("e");return`${Number(i)}e${Number(s)}`.replace("-","−")}let e=Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(n.toFixed(Math.min(6,e)))).replace("-","−")}function Kf(n){let t=10**Math.floor(Math.log10(n)),e=n/t;return t*(e<1.5?1:e<3.5?2:e<7.5?5:10)}function ko(n,t,e,i){return Y_(n,t,e,i*1.3)??Z_(n,t,e,i)}function Y_(n,t,e,i){let{layout:s,frame:r}=n.session;if(!s||!r)return null;let o=null,a=i,l=0;return s.variants.forEach((c,d)=>{c.anchors.forEach((u,h)=>{let f=Li(n.anchors.shown.subarray(l,l+3));if(l+=3,r.parts[d].anchors[10*h+9]<.5)return;let[g,_,m]=n.camera.project(...f),p=Math.hypot(g-t,_-e);if(m<=0||p>=a)return;a=p;let y=Math.min(u.index,c.nodes-2);o={kind:"anchor",variant:d,anchor:u.name,node:u.index,segment:y,place:f}})}),o}function Z_(n,t,e,i){let{layout:s}=n.session;if(!s)return null;let{shown:r}=n.nodes,o=null,a=i;return s.variants.forEach((l,c)=>{for(let d of l.ropes){let[u,h,f]=[0,0,!0];for(let g=d.first;g<d.first+d.nodes;g++){let _=4*(n.starts[c]+g),[m,p,y]=n.camera.project(r[_],r[_+1],r[_+2]);if(g>d.first&&!f&&y>0){let[A,M]=K_(t,e,u,h,m,p);if(A<a){a=A;let R=M>.5?g:g-1,T=4*(n.starts[c]+R),v=Li(r.subarray(T,T+3));o={kind:"node",variant:c,rope:d.name,node:R,segment:g-1,place:v}}}[u,h,f]=[m,p,y<=0]}}}),o}function Bo(n,t){let e=n.session.layout?.variants[t.variant];if(!e||t.node>=e.nodes)return null;let i=4*(n.starts[t.variant]+t.node);return Li(n.nodes.shown.subarray(i,i+3))}function K_(n,t,e,i,s,r){let[o,a]=[s-e,r-i],l=o*o+a*a,c=l>0?Math.min(1,Math.max(0,((n-e)*o+(t-i)*a)/l)):0;return[Math.hypot(n-e-c*o,t-i-c*a),c]}var J_=8,j_=40;function Q_(n,t){let[e]=n.variants,{anchors:i}=t.parts[0],s=new Map(e.anchors.filter((a,l)=>i[10*l+9]>.5).map(a=>[a.index,a.name])),r=e.loads.map(({index:a})=>a),o=e.ropes.length>4?0:J_;return e.ropes.flatMap(a=>{let l=a.nodes-1,c=Array.from({length:o+2},(h,f)=>Math.round(f*l/(o+1))).map(h=>a.first+h),d=[...s.keys(),...r].filter(h=>h>=a.first&&h<=a.first+l);return[...new Set([...c,...d])].sort((h,f)=>h-f).map(h=>{let f=Math.min(h,a.first+l-1),g={variant:0,node:h,segment:f,place:[0,0,0]},_=s.get(h);return _===void 0?{kind:"node",rope:a.name,...g}:{kind:"anchor",anchor:_,...g}})}).slice(0,j_)}function tx(n,t,e){let[i]=n.variants,[s]=t.parts;if(e.kind==="anchor"){let d=i.anchors.findIndex(({name:h})=>h===e.anchor),u=Math.hypot(...s.anchors.subarray(10*d+6,10*d+9));return`Anchor ${e.anchor}, force ${Ne(u,"N")}`}let r=i.ropes.find(({name:d})=>d===e.rope),o=r?`Node ${e.node-r.zero} of ${r.name}`:`Node ${e.node}`,a=i.loads.filter(({index:d})=>d===e.node).reduce((d,u)=>d+u.mass,0),l=Dr(n,s,s.tension[e.segment],"tension_low","tension_high"),c=a>0?`, load ${Ne(a,"kg")}`:"";return`${o}, tension ${Ne(l,"N")}${c}`}function ex(n,t,e){let[i]=t.parts,s=n.variants[0].anchors.filter((a,l)=>i.anchors[10*l+9]>.5).length,r=s===1?"one anchor holds":`${s} anchors hold`,o=Ne(en(n,i,"tension_high"),"N");return`${n.scene.name}: ${e} at ${Ne(t.time,"s")}, ${r}, greatest tension ${o}.`}var qa=class{constructor(t,e,i,s){this.stage=t,this.canvas=e,this.voice=i,this.menu=s,this.at=-1,this.state="",e.setAttribute("role","slider"),e.setAttribute("aria-label","Places on the ropes"),e.setAttribute("aria-valuemin","1"),e.addEventListener("keydown",r=>this.press(r)),e.addEventListener("blur",()=>this.go(-1)),e.addEventListener("pointerdown",()=>this.go(-1));for(let r of["status","broken","frame"])t.session.on(r,()=>this.tell())}get stops(){let{layout:t,frame:e}=this.stage.session;return t&&e?Q_(t,e):[]}press(t){let{stops:e}=this;if(t.key==="Tab"){let i=this.at<0&&t.shiftKey?-1:this.at+(t.shiftKey?-1:1);if(i<0||i>=e.length)return this.go(-1);t.preventDefault(),this.go(i)}else if(t.key==="Enter"&&e[this.at]){t.preventDefault();let i=Bo(this.stage,e[this.at]);if(!i)return;let[s,r]=this.stage.camera.project(...i);this.menu(e[this.at],s,r)}}go(t){let{stage:e,canvas:i}=this,{layout:s,frame:r}=e.session,{stops:o}=this,a=o[t]??null;this.at=a?t:-1,e.marks.chosen!==a&&(e.marks.dirty=!0),e.marks.chosen=a,i.setAttribute("aria-valuemax",String(o.length)),i.setAttribute("aria-valuenow",String(this.at+1));let l=a&&s&&r?tx(s,r,a):"None: Tab goes to the next";i.setAttribute("aria-valuetext",l)}tell(){let{layout:t,frame:e,status:i,broken:s}=this.stage.session;if(!t||!e)return;let r=s?"broken":i?.playing?"playing":"paused",o=`${t.scene.name} ${r}`;o!==this.state&&(this.state=o,this.voice.textContent=ex(t,e,r))}};var ix=.01;function Jf(n,t,e){let i=n.filter(({time:a})=>t-a<=e);if(i.length<2)return[0,0,0];let[s,r]=[i[0],i[i.length-1]],o=(t-s.time)/1e3;return o>0?Ze(En(r.place,s.place),1/o):[0,0,0]}function lu(n,t){if(!t?.playing)return 1;let e=n&&t.slow&&n.realtime>0?n.realtime:t.speed;return Math.max(ix,Math.min(e,t.speed))}var nx=8,sx=80,rx=40,ox=.05,ax=.05,Ya=class{constructor(t,e,i){this.stage=t,this.hit=e,this.way=i,this.place=e.place,this.sent=-1/0,this.pending=0,this.trace=[],this.limit=null}moveTo(t,e,i){let{stage:s,hit:r}=this;if(this.place=s.camera.onPlane(t,e,r.place,s.axis),this.way==="kick"){let a=`${Ie(Ks(this.velocity()))} m/s`;s.marks.kick={from:r.place,to:this.place,text:a},s.marks.dirty=!0;return}this.trace.push({time:i,place:this.place}),this.trace.length>rx&&this.trace.shift();let o=this.sent+nx-performance.now();o<=0?this.sendTarget():this.pending||=window.setTimeout(()=>this.sendTarget(),o)}sendTarget(){if(clearTimeout(this.pending),this.pending=0,this.over)return;this.sent=performance.now();let t=En(this.place,this.stage.shifts[this.hit.variant]),{hit:e,limit:i}=this,{session:s}=this.stage,r=lu(s.frame,s.status);e.kind==="anchor"?s.send({type:"drag",anchor:e.anchor,target:t,pace:r}):s.send({type:"grab",node:e.node,target:t,pace:r,limit:i})}velocity(){let{camera:t}=this.stage,e=t.pose.distance/t.focal;return Ze(En(this.place,this.hit.place),ax/e)}release(t,e){let{session:i,marks:s}=this.stage;if(this.way==="kick"){s.kick=null,s.dirty=!0;let r=this.velocity();Ks(r)>.05&&i.tell({type:"kick",node:this.hit.node,velocity:r})}else if(this.hit.kind==="anchor")this.sendTarget(),i.send({type:"drop",anchor:this.hit.anchor});else if(t)this.sendTarget();else{let r=lu(i.frame,i.status),o=i.status?.playing?Ze(Jf(this.trace,e,sx),1/r):[0,0,0],a=Ks(o)>ox?o:null;i.send({type:"let_go",node:this.hit.node,velocity:a})}this.over=!0}over=!1;get ring(){return ae(this.place,[0,0,0])}};var jf=18,lx=30,cx=2.2,hx=5,ux=550,dx=350,Za=class{constructor(t,e,i){this.stage=t,this.element=e,this.actions=i,this.tool="hand",this.keep=!1,this.limit=null,this.down=new Map,this.hands=new Map,this.near=!1,this.resting=null,this.hit=null,this.start=null,this.moved=!1,this.lastClick=0,this.longPress=0,this.menuOpened=!1,this.hovering=!1,e.addEventListener("pointerdown",s=>this.press(s)),e.addEventListener("pointermove",s=>this.move(s)),e.addEventListener("pointerrawupdate",s=>this.drag(s)),e.addEventListener("pointerup",s=>this.lift(s)),e.addEventListener("pointercancel",s=>this.lift(s)),e.addEventListener("pointerleave",()=>{this.resting=null,this.hover(null)}),t.beforeDraw.push(()=>this.look()),e.addEventListener("wheel",s=>this.wheel(s),{passive:!1}),e.addEventListener("contextmenu",s=>s.preventDefault())}at(t){let e=this.element.getBoundingClientRect();return{x:t.clientX-e.left,y:t.clientY-e.top}}reach(t){return t.pointerType==="mouse"?jf:lx}press(t){this.element.setPointerCapture(t.pointerId);let{x:e,y:i}=this.at(t);if(this.down.set(t.pointerId,{x:e,y:i}),this.stage.flight=null,this.down.size>1){clearTimeout(this.longPress);let s=this.hands.size>0?ko(this.stage,e,i,this.reach(t)):null;if(s&&this.hold(t.pointerId,s))return;this.dropHands(!1),this.moved=!0;return}this.start={x:e,y:i,button:t.button,shift:t.shiftKey},this.moved=this.menuOpened=!1,this.hit=ko(this.stage,e,i,this.reach(t)),this.near=!this.hit&&ko(this.stage,e,i,cx*this.reach(t))!==null,t.button===0&&this.hit&&!(t.ctrlKey||t.metaKey)&&this.hold(t.pointerId,this.hit),t.pointerType!=="mouse"&&(this.longPress=window.setTimeout(()=>this.openMenu(e,i),ux))}hold(t,e){let i=this.tool==="kick"?"kick":e.kind==="anchor"?"drag":"grab";if(this.tool!=="hand"&&this.tool!=="kick"||i!=="kick"&&!this.stage.session.can(i))return!1;let s=new Ya(this.stage,e,i);return s.limit=this.limit,this.hands.set(t,s),!0}move(t){let{x:e,y:i}=this.at(t),s=this.down.get(t.pointerId);if(!s){this.resting=t.pointerType==="mouse"?{x:e,y:i}:null,this.look();return}if(this.down.size===2&&this.hands.size<2){this.pinch(t.pointerId,e,i);return}let{start:r}=this;if(!r||!this.moved&&Math.hypot(e-r.x,i-r.y)<hx)return;this.moved=!0,clearTimeout(this.longPress);let[o,a]=[e-s.x,i-s.y];if(this.down.set(t.pointerId,{x:e,y:i}),this.menuOpened)return;let l=this.hands.get(t.pointerId);if(l)l.moveTo(e,i,t.timeStamp),this.stage.marks.hover=l.way==="kick"?null:l.ring,this.stage.marks.dirty=!0;else{if(this.hands.size)return;r.button!==0||r.shift||this.near?this.stage.camera.pan(o,a):this.stage.camera.orbit(o,a)}}drag(t){let e=this.hands.get(t.pointerId);if(!e||!this.moved||this.menuOpened)return;let{x:i,y:s}=this.at(t);e.moveTo(i,s,t.timeStamp)}lift(t){if(!this.down.delete(t.pointerId))return;clearTimeout(this.longPress);let{x:e,y:i}=this.at(t),s=this.hands.get(t.pointerId);s&&this.moved&&s.moveTo(e,i,t.timeStamp);let r=s!==void 0&&this.moved;this.dropHand(t.pointerId,t.shiftKey||this.keep,this.moved,t.timeStamp),!(this.moved||this.menuOpened||r||this.down.size)&&(t.button===2?this.openMenu(e,i):t.button===0&&this.click(t.timeStamp))}click(t){if(this.hit&&this.tool!=="hand"&&this.tool!=="kick"){this.actions.use(this.tool,this.hit);return}this.hit||(t-this.lastClick<dx&&this.letGo(),this.lastClick=t)}letGo(){this.stage.session.send({type:"let_go"})}openMenu(t,e){this.menuOpened=!0,this.dropHands(!1,!1),this.actions.menu(this.hit,t,e)}dropHand(t,e,i=!0,s=1/0){let r=this.hands.get(t);r&&(this.hands.delete(t),i&&r.release(e,s),this.hover(null))}dropHands(t,e=!0){for(let i of[...this.hands.keys()])this.dropHand(i,t,e)}look(){if(this.down.size)return;let{resting:t}=this;this.hover(t?ko(this.stage,t.x,t.y,jf):null)}pinch(t,e,i){let s=[...this.down.entries()].find(([l])=>l!==t)?.[1],r=this.down.get(t);if(!s||!r)return;let[o,a]=[r,{x:e,y:i}].map(l=>Math.hypot(l.x-s.x,l.y-s.y));this.stage.camera.pan((e-r.x)/2,(i-r.y)/2),a>1&&this.stage.camera.zoom(o/a,(e+s.x)/2,(i+s.y)/2),this.down.set(t,{x:e,y:i})}wheel(t){t.preventDefault();let{x:e,y:i}=this.at(t),s=t.deltaMode===1?18:1;this.stage.flight=null,this.stage.camera.zoom(Math.exp(Math.max(-60,Math.min(60,t.deltaY*s))*.003),e,i)}hover(t){let{marks:e}=this.stage;t===null&&e.hover===null||(e.hover=t,e.dirty=!0,this.element.classList.toggle("over",t!==null))}};var qe=["#3b8bc4","#d9652b","#1f9e77","#c879a7","#d99a1c","#5ab4e0","#8a8f98"];var fx=[[.555,.159,276],[.628,.114,307],[.719,.116,356],[.776,.105,32],[.828,.11,60],[.915,.142,103]],px=[[.346,.12,275],[.475,.135,315],[.555,.14,352],[.63,.165,22],[.7,.135,48],[.765,.15,82]],Qf=n=>n?1:.42,tp=n=>n?.022:.04,mx=(n,t,e)=>{let i=e*Math.PI/180;return[n,t*Math.cos(i),t*Math.sin(i)]};function gx([n,t,e]){let i=(n+.3963377774*t+.2158037573*e)**3,s=(n-.1055613458*t-.0638541728*e)**3,r=(n-.0894841775*t-1.291485548*e)**3;return[4.0767416621*i-3.3077115913*s+.2309699292*r,-1.2684380046*i+2.6097574011*s-.3413193965*r,-.0041960863*i-.7034186147*s+1.707614701*r]}var _x=n=>{let t=Math.min(1,Math.max(0,n));return t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055};function Ur(n){let t=n?fx:px,e=[],i=t.length-1;for(let a=0;a<=4e3;a++){let l=a/4e3*i,c=Math.min(i-1,Math.floor(l)),d=l-c,[u,h]=[t[c],t[c+1]],f=h[2]-u[2];f<-180&&(f+=360);let g=u[2]+d*f;e.push(mx(u[0]+d*(h[0]-u[0]),u[1]+d*(h[1]-u[1]),g))}let s=[0];for(let a=1;a<e.length;a++){let[l,c]=[e[a-1],e[a]];s.push(s[a-1]+Math.hypot(c[0]-l[0],c[1]-l[1],c[2]-l[2]))}let r=[],o=0;for(let a=0;a<256;a++){let l=s[s.length-1]*a/255;for(;o<s.length-1&&s[o]<l;)o++;r.push(gx(e[o]).map(_x))}return r}function Js(n){let t=parseInt(n.slice(1),16);return[(t>>16&255)/255,(t>>8&255)/255,(t&255)/255]}function Ke(n,t=1){let[e,i,s]=[0,1,2].map(r=>Math.round(255*n[r]));return t<1?`rgba(${e}, ${i}, ${s}, ${t})`:`rgb(${e}, ${i}, ${s})`}function H(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))r!=null&&(s.startsWith("on")?i.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"?i.setAttribute(s,String(r)):s==="data"?Object.assign(i.dataset,r):Object.assign(i,{[s]:r}));for(let s of e)s&&i.append(s);return i}var ep="http://www.w3.org/2000/svg",xx={play:"M8 5.5v13l10.5-6.5z",pause:"M8 5v14M16 5v14",step:"M6 5.5v13l9-6.5zM18.5 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4.5v4.2h4.2",fit:"M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",hand:"M8.5 12V6.2a1.4 1.4 0 0 1 2.8 0V11M11.3 10V4.9a1.4 1.4 0 0 1 2.8 0V11M14.1 10.5V6.3a1.4 1.4 0 0 1 2.8 0V14c0 4-2 6.5-5.3 6.5-3 0-4.3-1.5-5.8-4.2L4 13.2c-.8-1.5 1.1-2.6 2.2-1.3l2.3 2.6",pin:"M9 3.5h6M10 3.5l-.6 6.2L6.5 13h11l-2.9-3.3L14 3.5M12 13v7.5",cut:"M6.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM17.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM8 15.5L16.5 4M16 15.5L7.5 4",load:"M12 3v5M12 8a1.5 1.5 0 0 0 0 0M7.5 10h9l2.5 10H5z",kick:"M4 12h13M12 6l6 6-6 6",follow:"M4 18c3-9 6 1 9-6 2-4.5 4-4 7-6",graph:"M4 4v16h16M7.5 15l3.5-5 3.5 3 5-7.5",scenes:"M4 5.5h7v5.5H4zM13.5 5.5H20v5.5h-6.5zM4 13.5h7V19H4zM13.5 13.5H20V19h-6.5z",tour:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM15.8 8.2l-2.3 5.3-5.3 2.3 2.3-5.3z",compare:"M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",keep:"M12 4v10.5M7.5 10.5L12 15l4.5-4.5M4.5 16v3.5h15V16",help:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM9.5 9.5a2.6 2.6 0 1 1 3.6 2.4c-.8.4-1.1.9-1.1 1.8M12 16.8v.2",theme:"M12 20.5a8.5 8.5 0 1 0 0-17zM12 20.5a8.5 8.5 0 0 1 0-17",panel:"M4 7h9M17 7h3M15 5v4M4 12h3M11 12h9M9 10v4M4 17h11M19 17h1M17 15v4",close:"M6 6l12 12M18 6L6 18",down:"M6 9.5l6 6 6-6",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",sound:"M4 9.5v5h3.5L12 18.5v-13L7.5 9.5zM15 9.5a3.5 3.5 0 0 1 0 5M17.5 7a7 7 0 0 1 0 10",undo:"M8.5 6L4.5 10l4 4M4.5 10h9a5.5 5.5 0 0 1 0 11h-2"};function mn(n,t=!1){let e=document.createElementNS(ep,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.classList.add("icon"),t&&e.classList.add("solid");let i=document.createElementNS(ep,"path");return i.setAttribute("d",xx[n]),e.append(i),e}function xi(n,t,e,i={}){let s=i.key?`${t} (${i.key})`:t;return H("button",{type:"button",title:s,"aria-label":t,onclick:e,id:i.id??"",className:i.kind??"plain"},mn(n,n==="play"),i.words&&H("span",{className:"words"},i.words))}function Or(n,t,...e){let i=H("button",{type:"button",className:"plain close","aria-label":"Close",title:"Close"},mn("close")),s=H("dialog",{className:`window ${t}`,"aria-label":n},H("header",{},H("h2",{},n),i),...e);return i.onclick=()=>s.close(),s.addEventListener("close",()=>{document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),s.addEventListener("click",r=>{r.target===s&&s.close()}),s}function zo(n,t,e,i,s=""){n.querySelector(".popup")?.remove();let r=H("div",{className:"popup",role:"menu"},s&&H("div",{className:"popup-title"},s)),o=()=>{r.remove(),removeEventListener("pointerdown",a,!0),removeEventListener("keydown",l,!0)},a=d=>{r.contains(d.target)||o()},l=d=>{d.key==="Escape"&&o()};for(let d of i){let u=()=>{o(),d.press()};r.append(H("button",{type:"button",role:"menuitem",onclick:u,disabled:d.disabled??!1,id:d.id??""},d.label,d.hint&&H("small",{},d.hint)))}n.append(r);let c=n.getBoundingClientRect();return r.style.left=`${Math.max(4,Math.min(t,c.width-r.offsetWidth-4))}px`,r.style.top=`${Math.max(4,Math.min(e,c.height-r.offsetHeight-4))}px`,addEventListener("pointerdown",a,!0),addEventListener("keydown",l,!0),r.querySelector("button")?.focus({preventScroll:!0}),r}function cu(n,t){let e=H("a",{href:n,download:t});document.body.append(e),e.click(),e.remove()}var Ka=class{constructor(){this.count=0,this.start=0,this.time=new Float64Array(2*7200),this.columns=new Map}clear(){this.count=this.start=0,this.columns.clear()}add(t,e){if(this.count>0&&t<=this.last){if(t===this.last)return;this.count=this.search(t)}if(this.start+this.count===2*7200){for(let s of[this.time,...this.columns.values()])s.copyWithin(0,this.start+1);this.start=0,this.count=7199}let i=this.start+this.count;this.time[i]=t;for(let s of this.columns.values())s[i]=NaN;for(let[s,r]of e){let o=this.columns.get(s);o||(o=new Float64Array(2*7200).fill(NaN),this.columns.set(s,o)),o[i]=r}this.count++,this.count>7200&&(this.count=7200,this.start++)}get last(){return this.count?this.time[this.start+this.count-1]:NaN}get first(){return this.count?this.time[this.start]:NaN}between(t,e,i){let s=Math.max(0,this.search(t)-1),r=Math.min(this.count,this.search(e)+1),[o,a]=[this.start+s,this.start+r],l=new Float64Array(a-o).fill(NaN);return[this.time.subarray(o,a),...i.map(c=>this.columns.get(c)?.subarray(o,a)??l)]}search(t){let[e,i]=[0,this.count];for(;e<i;){let s=e+i>>1;this.time[this.start+s]<t?e=s+1:i=s}return e}};var Yi={left:46,right:10,top:8,bottom:34},Ja=class{constructor(t){this.canvas=H("canvas",{className:"phase"}),this.host=t,t.append(this.canvas)}resize(){let t=devicePixelRatio||1,{clientWidth:e,clientHeight:i}=this.host,[s,r]=[e*t,i*t].map(Math.round);(this.canvas.width!==s||this.canvas.height!==r)&&(this.canvas.width=s,this.canvas.height=r)}show(t,e,i){let s=this.canvas.getContext("2d");if(!s)return;let r=devicePixelRatio||1,[o,a]=[this.canvas.width/r,this.canvas.height/r];s.setTransform(r,0,0,r,0,0),s.clearRect(0,0,o,a);let l=[];for(let M=1;M+1<t.length;M++){let R=(e[M+1]-e[M-1])/(t[M+1]-t[M-1]);Number.isFinite(R)&&l.push([e[M],R])}let c=getComputedStyle(document.documentElement),d=c.getPropertyValue("--faint").trim();if(s.font="11px system-ui, sans-serif",s.fillStyle=d,l.length<3){s.fillText("Follow a node to see its phase plane.",12,24);return}let[u,h]=ip(l.map(([M])=>M)),[f,g]=ip(l.map(([,M])=>M)),_={w:o-Yi.left-Yi.right,h:a-Yi.top-Yi.bottom},m=M=>Yi.left+(M-u)/(h-u)*_.w,p=M=>Yi.top+(1-(M-f)/(g-f))*_.h;s.strokeStyle=c.getPropertyValue("--line").trim(),s.strokeRect(Yi.left,Yi.top,_.w,_.h),f<0&&g>0&&(s.beginPath(),s.moveTo(Yi.left,p(0)),s.lineTo(Yi.left+_.w,p(0)),s.stroke()),s.textAlign="right";for(let M of[f,g])s.fillText(Ie(Number(M.toPrecision(2))),Yi.left-4,p(M)+(M===f?0:9));s.textAlign="left",s.fillText(Ie(Number(u.toPrecision(3))),Yi.left,a-20),s.textAlign="right",s.fillText(Ne(Number(h.toPrecision(3)),"m"),o-Yi.right,a-20),s.textAlign="center",s.fillText("height; upward velocity in m/s",Yi.left+_.w/2,a-5),s.textAlign="left",s.strokeStyle=i,s.lineWidth=1.4,s.beginPath();for(let[M,R]of l)s.lineTo(m(M),p(R));s.stroke();let[y,A]=l[l.length-1];s.fillStyle=i,s.beginPath(),s.arc(m(y),p(A),4,0,2*Math.PI),s.fill()}};function ip(n){let[t,e]=[1/0,-1/0];for(let s of n)t=Math.min(t,s),e=Math.max(e,s);let i=Math.max(1e-6,.06*(e-t));return[t-i,e+i]}var vx="uplot",yx="u-hz",Mx="u-vt",Sx="u-title",bx="u-wrap",wx="u-under",Ex="u-over",Tx="u-axis",tr="u-off",Ax="u-select",Rx="u-cursor-x",Cx="u-cursor-y",Px="u-cursor-pt",Ix="u-legend",Lx="u-live",Nx="u-inline",Dx="u-series",Fx="u-marker",np="u-label",Ux="u-value",Ho="width",Go="height";var sp="bottom",kr="left",hu="right",Au="#000",rp=Au+"0",uu="mousemove",op="mousedown",du="mouseup",ap="mouseenter",lp="mouseleave",cp="dblclick",Ox="resize",kx="scroll",hp="change",il="dppxchange",Ru="--",Xr=typeof window<"u",_u=Xr?document:null,zr=Xr?window:null,Bx=Xr?navigator:null,be,ja;function xu(){let n=devicePixelRatio;be!=n&&(be=n,ja&&yu(hp,ja,xu),ja=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),er(hp,ja,xu),zr.dispatchEvent(new CustomEvent(il)))}function nn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function vu(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function He(n,t,e){n.style[t]=e+"px"}function Tn(n,t,e,i){let s=_u.createElement(n);return t!=null&&nn(s,t),e?.insertBefore(s,i),s}function gn(n,t){return Tn("div",n,t)}var up=new WeakMap;function Xn(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=up.get(n);r!=o&&(n.style.transform=r,up.set(n,r),t<0||e<0||t>i||e>s?nn(n,tr):vu(n,tr))}var dp=new WeakMap;function fp(n,t,e){let i=t+e,s=dp.get(n);i!=s&&(dp.set(n,i),n.style.background=t,n.style.borderColor=e)}var pp=new WeakMap;function mp(n,t,e,i){let s=t+""+e,r=pp.get(n);s!=r&&(pp.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Cu={passive:!0},zx={...Cu,capture:!0};function er(n,t,e,i){t.addEventListener(n,e,i?zx:Cu)}function yu(n,t,e,i){t.removeEventListener(n,e,Cu)}Xr&&xu();function An(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:sn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Gp(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Wp=n=>n!=null,Xp=n=>n!=null&&n>0,rl=Gp(Wp),Vx=Gp(Xp);function Hx(n,t,e,i=0,s=!1){let r=s?Vx:rl,o=s?Xp:Wp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let d=n[c];o(d)&&(d<a?a=d:d>l&&(l=d))}return[a??De,l??-De]}function ol(n,t,e,i){let s=xp(n),r=xp(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?as:$p,a=s==1?sn:_n,l=r==1?_n:sn,c=a(o(yi(n))),d=l(o(yi(t))),u=Vr(e,c),h=Vr(e,d);return e==10&&(c<0&&(u=Fe(u,-c)),d<0&&(h=Fe(h,-d))),i||e==2?(n=u*s,t=h*r):(n=Kp(n,u),t=al(t,h)),[n,t]}function Pu(n,t,e,i){let s=ol(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Iu=.1,gp={mode:3,pad:Iu},Xo={pad:0,soft:null,mode:0},Gx={min:Xo,max:Xo};function nl(n,t,e,i){return ll(e)?_p(n,t,e):(Xo.pad=e,Xo.soft=i?0:null,Xo.mode=i?3:0,_p(n,t,Gx))}function Me(n,t){return n??t}function Wx(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function _p(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-De),l=Me(s.hard,De),c=Me(i.soft,De),d=Me(s.soft,-De),u=Me(i.mode,0),h=Me(s.mode,0),f=t-n,g=as(f),_=Gi(yi(n),yi(t)),m=as(_),p=yi(m-g);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&c!=De&&(r=0),h==2&&d!=-De&&(o=0)));let y=f||_||1e3,A=as(y),M=Vr(10,sn(A)),R=y*(f==0?n==0?.1:1:r),T=Fe(Kp(n-R,M/10),24),v=n>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:De,E=Gi(a,T<v&&n>=v?v:Rn(v,T)),k=y*(f==0?t==0?.1:1:o),D=Fe(al(t+k,M/10),24),L=t<=d&&(h==1||h==3&&D>=d||h==2&&D<=d)?d:-De,G=Rn(l,D>L&&t<=L?L:Gi(L,D));return E==G&&E==0&&(G=100),[E,G]}var Xx=new Intl.NumberFormat(Xr?Bx.language:"en-US"),Lu=n=>Xx.format(n),rn=Math,el=rn.PI,yi=rn.abs,sn=rn.floor,vi=rn.round,_n=rn.ceil,Rn=rn.min,Gi=rn.max,Vr=rn.pow,xp=rn.sign,as=rn.log10,$p=rn.log2,$x=(n,t=1)=>rn.sinh(n)*t,fu=(n,t=1)=>rn.asinh(n/t),De=1/0;function vp(n){return(as((n^n>>31)-(n>>31))|0)+1}function Mu(n,t,e){return Rn(Gi(n,t),e)}function qp(n){return typeof n=="function"}function pe(n){return qp(n)?n:()=>n}var qx=()=>{},Yp=n=>n,Zp=(n,t)=>t,Yx=n=>null,yp=n=>!0,Mp=(n,t)=>n==t,Zx=/\.\d*?(?=9{6,}|0{6,})/gm,ir=n=>{if(jp(n)||Cs.has(n))return n;let t=`${n}`,e=t.match(Zx);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ir(s)}e${r}`}return Fe(n,i)};function js(n,t){return ir(Fe(ir(n/t))*t)}function al(n,t){return ir(_n(ir(n/t))*t)}function Kp(n,t){return ir(sn(ir(n/t))*t)}function Fe(n,t=0){if(jp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return vi(i)/e}var Cs=new Map;function Jp(n){return((""+n).split(".")[1]||"").length}function qo(n,t,e,i){let s=[],r=i.map(Jp);for(let o=t;o<e;o++){let a=yi(o),l=Fe(Vr(n,o),a);for(let c=0;c<i.length;c++){let d=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?d:Fe(d,u);s.push(h),Cs.set(h,u)}}return s}var $o={},Nu=[],Hr=[null,null],Rs=Array.isArray,jp=Number.isInteger,Kx=n=>n===void 0;function Sp(n){return typeof n=="string"}function ll(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Jx(n){return n!=null&&typeof n=="object"}var jx=Object.getPrototypeOf(Uint8Array),Qp="__proto__";function Gr(n,t=ll){let e;if(Rs(n)){let i=n.find(s=>s!=null);if(Rs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Gr(n[s],t)}else e=n.slice()}else if(n instanceof jx)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Qp&&(e[i]=Gr(n[i],t))}else e=n;return e}function di(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Qp&&(ll(n[s])?di(n[s],Gr(i[s])):n[s]=Gr(i[s]))}return n}var Qx=0,tv=1,ev=2;function iv(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function nv(n,t){if(ov(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return av(o[0])||(o=rv(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let d=0;d<c;d++)e.add(l[d])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let d=a[c],u=Array(s).fill(void 0),h=t?t[o][c]:tv,f=[];for(let g=0;g<d.length;g++){let _=d[g],m=r.get(l[g]);_===null?h!=Qx&&(u[m]=_,h==ev&&f.push(m)):u[m]=_}iv(u,f,s),i.push(u)}}return i}var sv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function rv(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function ov(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function av(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Gi(1,sn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var tm=["January","February","March","April","May","June","July","August","September","October","November","December"],em=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function im(n){return n.slice(0,3)}var lv=em.map(im),cv=tm.map(im),hv={MMMM:tm,MMM:cv,WWWW:em,WWW:lv};function Vo(n){return(n<10?"0":"")+n}function uv(n){return(n<10?"00":n<100?"0":"")+n}var dv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Vo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Vo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Vo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Vo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Vo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>uv(n.getMilliseconds())};function Du(n,t){t=t||hv;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?dv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var fv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function pv(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==fv?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var nm=n=>n%1==0,sl=[1,2,2.5,5],mv=qo(10,-32,0,sl),sm=qo(10,0,32,sl),gv=sm.filter(nm),Qs=mv.concat(sm),Fu=`
`,rm="{YYYY}",bp=Fu+rm,om="{M}/{D}",Wo=Fu+om,Qa=Wo+"/{YY}",am="{aa}",_v="{h}:{mm}",Br=_v+am,wp=Fu+Br,Ep=":{ss}",we=null;function lm(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?qo(10,0,3,sl).filter(nm):qo(10,-3,0,sl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,rm,we,we,we,we,we,we,1],[s*28,"{MMM}",bp,we,we,we,we,we,1],[s,om,bp,we,we,we,we,we,1],[i,"{h}"+am,Qa,we,Wo,we,we,we,1],[e,Br,Qa,we,Wo,we,we,we,1],[t,Ep,Qa+" "+Br,we,Wo+" "+Br,we,wp,we,1],[n,Ep+".{fff}",Qa+" "+Br,we,Wo+" "+Br,we,wp,we,1]];function d(u){return(h,f,g,_,m,p)=>{let y=[],A=m>=o,M=m>=r&&m<o,R=u(g),T=Fe(R*n,3),v=pu(R.getFullYear(),A?0:R.getMonth(),M||A?1:R.getDate()),E=Fe(v*n,3);if(M||A){let k=M?m/r:0,D=A?m/o:0,L=T==E?T:Fe(pu(v.getFullYear()+D,v.getMonth()+k,1)*n,3),G=new Date(vi(L/n)),W=G.getFullYear(),N=G.getMonth();for(let V=0;L<=_;V++){let X=pu(W+D*V,N+k*V,1),O=X-u(Fe(X*n,3));L=Fe((+X+O)*n,3),L<=_&&y.push(L)}}else{let k=m>=s?s:m,D=sn(g)-sn(T),L=E+D+al(T-E,k);y.push(L);let G=u(L),W=G.getHours()+G.getMinutes()/e+G.getSeconds()/i,N=m/i,V=h.axes[f]._space,X=p/V;for(;L=Fe(L+m,n==1?0:3),!(L>_);)if(N>1){let O=sn(Fe(W+N,6))%24,Q=u(L).getHours()-O;Q>1&&(Q=-1),L-=Q*i,W=(W+N)%24;let st=y[y.length-1];Fe((L-st)/m,3)*X>=.7&&y.push(L)}else y.push(L)}return y}}return[l,c,d]}var[xv,vv,yv]=lm(1),[Mv,Sv,bv]=lm(.001);qo(2,-53,53,[1]);function Tp(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Ap(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,d,u,h,f;return i.map(g=>{let _=n(g),m=_.getFullYear(),p=_.getMonth(),y=_.getDate(),A=_.getHours(),M=_.getMinutes(),R=_.getSeconds(),T=m!=l&&a[2]||p!=c&&a[3]||y!=d&&a[4]||A!=u&&a[5]||M!=h&&a[6]||R!=f&&a[7]||a[1];return l=m,c=p,d=y,u=A,h=M,f=R,T(_)})}}function wv(n,t){let e=Du(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function pu(n,t,e){return new Date(n,t,e)}function Rp(n,t){return t(n)}var Ev="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Cp(n,t){return(e,i,s,r)=>r==null?Ru:t(n(i))}function Tv(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function Av(n,t){return n.series[t].fill(n,t)}var Rv={show:!0,live:!0,isolate:!1,mount:qx,markers:{show:!0,width:2,stroke:Tv,fill:Av,dash:"solid"},idx:null,idxs:null,values:[]};function Cv(n,t){let e=n.cursor.points,i=gn(),s=e.size(n,t);He(i,Ho,s),He(i,Go,s);let r=s/-2;He(i,"marginLeft",r),He(i,"marginTop",r);let o=e.width(n,t,s);return o&&He(i,"borderWidth",o),i}function Pv(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Iv(n,t){let e=n.series[t].points;return e._stroke||e._fill}function Lv(n,t){return n.series[t].points.size}var mu=[0,0];function Nv(n,t,e){return mu[0]=t,mu[1]=e,mu}function tl(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function gu(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var Dv={show:!0,x:!0,y:!0,lock:!1,move:Nv,points:{one:!1,show:Cv,size:Lv,width:0,stroke:Iv,fill:Pv},bind:{mousedown:tl,mouseup:tl,click:tl,dblclick:tl,mousemove:gu,mouseleave:gu,mouseenter:gu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},cm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Uu=di({},cm,{filter:Zp}),hm=di({},Uu,{size:10}),um=di({},cm,{show:!1}),Ou='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',dm="bold "+Ou,fm=1.5,Pp={show:!0,scale:"x",stroke:Au,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:dm,side:2,grid:Uu,ticks:hm,border:um,font:Ou,lineGap:fm,rotate:0},Fv="Value",Uv="Time",Ip={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function Ov(n,t,e,i,s){return t.map(r=>r==null?"":Lu(r))}function kv(n,t,e,i,s,r,o){let a=[],l=Cs.get(s)||0;e=o?e:Fe(al(e,s),l);for(let c=e;c<=i;c=Fe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Su(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?as:$p,d=sn(c(e));s=Vr(l,d),l==10&&(s=Qs[An(s,Qs)]);let u=e,h=s*l;l==10&&(h=Qs[An(h,Qs)]);do a.push(u),u=u+s,l==10&&!Cs.has(u)&&(u=Fe(u,Cs.get(s))),u>=h&&(s=u,h=s*l,l==10&&(h=Qs[An(h,Qs)]));while(u<=i);return a}function Bv(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Su(n,t,Gi(l,e),i,s):[l],d=i>=0&&e<=0?[0]:[];return(e<-l?Su(n,t,Gi(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(d,c)}var pm=/./,zv=/[12357]/,Vv=/[125]/,Lp=/1/,bu=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Hv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,d=l(10,o),u=l(9,o)-d>=c?pm:l(7,o)-d>=c?zv:l(5,o)-d>=c?Vv:Lp;if(u==Lp){let h=yi(l(1,o)-d);if(h<c)return bu(t.slice().reverse(),a.distr,u,_n(c/h)).reverse()}return bu(t,a.distr,u,1)}function Gv(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=yi(l(1,o)-l(2,o));return c<a?bu(t.slice().reverse(),3,pm,_n(a/c)).reverse():t}function Wv(n,t,e,i){return i==null?Ru:t==null?"":Lu(t)}var Np={show:!0,scale:"y",stroke:Au,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:dm,side:3,grid:Uu,ticks:hm,border:um,font:Ou,lineGap:fm,rotate:0};function Xv(n,t){let e=3+(n||1)*2;return Fe(e*t,3)}function $v(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=yi(o-r),l=n.series[t],c=a/(l.points.space*be);return i[1]-i[0]<=c}var Dp={scale:null,auto:!0,sorted:0,min:De,max:-De},mm=(n,t,e,i,s)=>s,Fp={show:!0,auto:!0,sorted:0,gaps:mm,alpha:1,facets:[di({},Dp,{scale:"x"}),di({},Dp,{scale:"y"})]},Up={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:mm,alpha:1,points:{show:$v,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function qv(n,t,e,i,s){return e/10}var gm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Yv=di({},gm,{time:!1,ori:1}),Op={};function _m(n,t){let e=Op[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let d=0;d<e.plots.length;d++)e.plots[d]!=s&&e.plots[d].pub(i,s,r,o,a,l,c)}},n!=null&&(Op[n]=e)),e}var Wr=1,wu=2;function nr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],d=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,g=a.width,_=a.height,m=n.valToPosH,p=n.valToPosV;return d.ori==0?e(s,l,c,d,u,m,p,h,f,g,_,hl,$r,dl,vm,Mm):e(s,l,c,d,u,p,m,f,h,_,g,ul,qr,zu,ym,Sm)}function ku(n,t){let e=0,i=0,s=Me(n.bands,Nu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Zv(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ls(n,t,e,i,s,r){return nr(n,t,(o,a,l,c,d,u,h,f,g,_,m)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),A=c.ori==0?$r:qr,M,R;y==1?(M=e,R=i):(M=i,R=e);let T=p(u(a[M],c,_,f)),v=p(h(l[M],d,m,g)),E=p(u(a[R],c,_,f)),k=p(h(r==1?d.max:d.min,d,m,g)),D=new Path2D(s);return A(D,E,k),A(D,T,k),A(D,T,v),D})}function cl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?dl:zu,l=e;for(let u=0;u<n.length;u++){let h=n[u];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=e+s-l,d=10;c>0&&a(o,l,i-d/2,c,i+r+d)}return o}function Kv(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Bu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let f=r(n[u]),g=h==u?f:r(n[h]),_=u-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let p=h+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=f&&a.push([f,g])}return a}function kp(n){return n==0?Yp:n==1?vi:t=>js(t,n)}function xm(n){let t=n==0?hl:ul,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,d=0)=>{c==0&&d==0?i(s,r,o,a,l):(c=Rn(c,a/2,l/2),d=Rn(d,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,d),e(s,r,o+l,r,o,d),e(s,r,o,r+a,o,c),s.closePath())}}var hl=(n,t,e)=>{n.moveTo(t,e)},ul=(n,t,e)=>{n.moveTo(e,t)},$r=(n,t,e)=>{n.lineTo(t,e)},qr=(n,t,e)=>{n.lineTo(e,t)},dl=xm(0),zu=xm(1),vm=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},ym=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Mm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Sm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function bm(n){return(t,e,i,s,r)=>nr(t,e,(o,a,l,c,d,u,h,f,g,_,m)=>{let{pxRound:p,points:y}=o,A,M;c.ori==0?(A=hl,M=vm):(A=ul,M=ym);let R=Fe(y.width*be,3),T=(y.size-y.width)/2*be,v=Fe(T*2,3),E=new Path2D,k=new Path2D,{left:D,top:L,width:G,height:W}=t.bbox;dl(k,D-v,L-v,G+v*2,W+v*2);let N=V=>{if(l[V]!=null){let X=p(u(a[V],c,_,f)),O=p(h(l[V],d,m,g));A(E,X+T,O),M(E,X,O,T,0,el*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:R>0?E:null,fill:E,clip:k,flags:Wr|wu}})}function wm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var Jv=wm($r),jv=wm(qr);function Em(n){let t=Me(n?.alignGaps,0);return(e,i,s,r)=>nr(e,i,(o,a,l,c,d,u,h,f,g,_,m)=>{[s,r]=rl(l,s,r);let p=o.pxRound,y=W=>p(u(W,c,_,f)),A=W=>p(h(W,d,m,g)),M,R;c.ori==0?(M=$r,R=Jv):(M=qr,R=jv);let T=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Wr},E=v.stroke,k=!1;if(r-s>=_*4){let W=ut=>e.posToVal(ut,c.key,!0),N=null,V=null,X,O,lt,Z=y(a[T==1?s:r]),Q=y(a[s]),st=y(a[r]),dt=W(T==1?Q+1:st-1);for(let ut=T==1?s:r;ut>=s&&ut<=r;ut+=T){let tt=a[ut],xt=(T==1?tt<dt:tt>dt)?Z:y(tt),At=l[ut];xt==Z?At!=null?(O=At,N==null?(M(E,xt,A(O)),X=N=V=O):O<N?N=O:O>V&&(V=O)):At===null&&(k=!0):(N!=null&&R(E,Z,A(N),A(V),A(X),A(O)),At!=null?(O=At,M(E,xt,A(O)),N=V=X=O):(N=V=null,At===null&&(k=!0)),Z=xt,dt=W(Z+T))}N!=null&&N!=V&&lt!=Z&&R(E,Z,A(N),A(V),A(X),A(O))}else for(let W=T==1?s:r;W>=s&&W<=r;W+=T){let N=l[W];N===null?k=!0:N!=null&&M(E,y(a[W]),A(N))}let[L,G]=ku(e,i);if(o.fill!=null||L!=0){let W=v.fill=new Path2D(E),N=o.fillTo(e,i,o.min,o.max,L),V=A(N),X=y(a[s]),O=y(a[r]);T==-1&&([O,X]=[X,O]),M(W,O,V),M(W,X,V)}if(!o.spanGaps){let W=[];k&&W.push(...Bu(a,l,s,r,T,y,t)),v.gaps=W=o.gaps(e,i,s,r,W),v.clip=cl(W,c.ori,f,g,_,m)}return G!=0&&(v.band=G==2?[ls(e,i,s,r,E,-1),ls(e,i,s,r,E,1)]:ls(e,i,s,r,E,G)),v})}function Qv(n){let t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>nr(r,o,(c,d,u,h,f,g,_,m,p,y,A)=>{[a,l]=rl(u,a,l);let M=c.pxRound,{left:R,width:T}=r.bbox,v=Q=>M(g(Q,h,y,m)),E=Q=>M(_(Q,f,A,p)),k=h.ori==0?$r:qr,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Wr},L=D.stroke,G=h.dir*(h.ori==0?1:-1),W=E(u[G==1?a:l]),N=v(d[G==1?a:l]),V=N,X=N;s&&t==-1&&(X=R,k(L,X,W)),k(L,N,W);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let st=u[Q];if(st==null)continue;let dt=v(d[Q]),ut=E(st);t==1?k(L,dt,W):k(L,V,ut),k(L,dt,ut),W=ut,V=dt}let O=V;s&&t==1&&(O=R+T,k(L,O,W));let[lt,Z]=ku(r,o);if(c.fill!=null||lt!=0){let Q=D.fill=new Path2D(L),st=c.fillTo(r,o,c.min,c.max,lt),dt=E(st);k(Q,O,dt),k(Q,X,dt)}if(!c.spanGaps){let Q=[];Q.push(...Bu(d,u,a,l,G,v,i));let st=c.width*be/2,dt=e||t==1?st:-st,ut=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),D.gaps=Q=c.gaps(r,o,a,l,Q),D.clip=cl(Q,h.ori,m,p,y,A)}return Z!=0&&(D.band=Z==2?[ls(r,o,a,l,L,-1),ls(r,o,a,l,L,1)]:ls(r,o,a,l,L,Z)),D})}function Bp(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let d=yi(n[l]-n[a]);d<c&&(c=d,o=yi(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function ty(n){n=n||$o;let t=Me(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=pe(s),o=1-t[0],a=Me(t[1],De),l=Me(t[2],1),c=Me(n.disp,$o),d=Me(n.each,f=>{}),{fill:u,stroke:h}=c;return(f,g,_,m)=>nr(f,g,(p,y,A,M,R,T,v,E,k,D,L)=>{let G=p.pxRound,W=e,N=i*be,V=a*be,X=l*be,O,lt;M.ori==0?[O,lt]=r(f,g):[lt,O]=r(f,g);let Z=M.dir*(M.ori==0?1:-1),Q=M.ori==0?dl:zu,st=M.ori==0?d:(Ct,$t,ne,bt,Le,zt,Xt)=>{d(Ct,$t,ne,Le,bt,Xt,zt)},dt=Me(f.bands,Nu).find(Ct=>Ct.series[0]==g),ut=dt!=null?dt.dir:0,tt=p.fillTo(f,g,p.min,p.max,ut),mt=G(v(tt,R,L,k)),xt,At,St,Gt=D,ie=G(p.width*be),Vt=!1,ce=null,re=null,te=null,We=null;u!=null&&(ie==0||h!=null)&&(Vt=!0,ce=u.values(f,g,_,m),re=new Map,new Set(ce).forEach(Ct=>{Ct!=null&&re.set(Ct,new Path2D)}),ie>0&&(te=h.values(f,g,_,m),We=new Map,new Set(te).forEach(Ct=>{Ct!=null&&We.set(Ct,new Path2D)})));let{x0:Ue,size:oi}=c;if(Ue!=null&&oi!=null){W=1,y=Ue.values(f,g,_,m),Ue.unit==2&&(y=y.map(ne=>f.posToVal(E+ne*D,M.key,!0)));let Ct=oi.values(f,g,_,m);oi.unit==2?At=Ct[0]*D:At=T(Ct[0],M,D,E)-T(0,M,D,E),Gt=Bp(y,A,T,M,D,E,Gt),St=Gt-At+N}else Gt=Bp(y,A,T,M,D,E,Gt),St=Gt*o+N,At=Gt-St;St<1&&(St=0),ie>=At/2&&(ie=0),St<5&&(G=Yp);let Ce=St>0,wi=Gt-St-(Ce?ie:0);At=G(Mu(wi,X,V)),xt=(W==0?At/2:W==Z?0:At)-W*Z*((W==0?N/2:0)+(Ce?ie/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gi=Vt?null:new Path2D,je=null;if(dt!=null)je=f.data[dt.series[1]];else{let{y0:Ct,y1:$t}=c;Ct!=null&&$t!=null&&(A=$t.values(f,g,_,m),je=Ct.values(f,g,_,m))}let ai=O*At,U=lt*At;for(let Ct=Z==1?_:m;Ct>=_&&Ct<=m;Ct+=Z){let $t=A[Ct];if($t==null)continue;if(je!=null){let $=je[Ct]??0;if($t-$==0)continue;mt=v($,R,L,k)}let ne=M.distr!=2||c!=null?y[Ct]:Ct,bt=T(ne,M,D,E),Le=v(Me($t,tt),R,L,k),zt=G(bt-xt),Xt=G(Gi(Le,mt)),C=G(Rn(Le,mt)),S=Xt-C;if($t!=null){let $=$t<0?U:ai,ht=$t<0?ai:U;Vt?(ie>0&&te[Ct]!=null&&Q(We.get(te[Ct]),zt,C+sn(ie/2),At,Gi(0,S-ie),$,ht),ce[Ct]!=null&&Q(re.get(ce[Ct]),zt,C+sn(ie/2),At,Gi(0,S-ie),$,ht)):Q(gi,zt,C+sn(ie/2),At,Gi(0,S-ie),$,ht),st(f,g,Ct,zt-ie/2,C,At+ie,S)}}return ie>0?ve.stroke=Vt?We:gi:Vt||(ve._fill=p.width==0?p._fill:p._stroke??p._fill,ve.width=0),ve.fill=Vt?re:gi,ve})}function ey(n,t){let e=Me(t?.alignGaps,0);return(i,s,r,o)=>nr(i,s,(a,l,c,d,u,h,f,g,_,m,p)=>{[r,o]=rl(c,r,o);let y=a.pxRound,A=O=>y(h(O,d,m,g)),M=O=>y(f(O,u,p,_)),R,T,v;d.ori==0?(R=hl,v=$r,T=Mm):(R=ul,v=qr,T=Sm);let E=d.dir*(d.ori==0?1:-1),k=A(l[E==1?r:o]),D=k,L=[],G=[];for(let O=E==1?r:o;O>=r&&O<=o;O+=E)if(c[O]!=null){let Z=l[O],Q=A(Z);L.push(D=Q),G.push(M(c[O]))}let W={stroke:n(L,G,R,v,T,y),fill:null,clip:null,band:null,gaps:null,flags:Wr},N=W.stroke,[V,X]=ku(i,s);if(a.fill!=null||V!=0){let O=W.fill=new Path2D(N),lt=a.fillTo(i,s,a.min,a.max,V),Z=M(lt);v(O,D,Z),v(O,k,Z)}if(!a.spanGaps){let O=[];O.push(...Bu(l,c,r,o,E,A,e)),W.gaps=O=a.gaps(i,s,r,o,O),W.clip=cl(O,d.ori,g,_,m,p)}return X!=0&&(W.band=X==2?[ls(i,s,r,o,N,-1),ls(i,s,r,o,N,1)]:ls(i,s,r,o,N,X)),W})}function iy(n){return ey(ny,n)}function ny(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),d=Array(o-1),u=Array(o-1);for(let h=0;h<o-1;h++)d[h]=t[h+1]-t[h],u[h]=n[h+1]-n[h],c[h]=d[h]/u[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(u[h-1]+u[h])/((2*u[h]+u[h-1])/c[h-1]+(u[h]+2*u[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+u[h]/3,t[h]+l[h]*u[h]/3,n[h+1]-u[h]/3,t[h+1]-l[h+1]*u[h]/3,n[h+1],t[h+1])}return a}var Eu=new Set;function zp(){for(let n of Eu)n.syncRect(!0)}Xr&&(er(Ox,zr,zp),er(kx,zr,zp,!0),er(il,zr,()=>{Ni.pxRatio=be}));var sy=Em(),ry=bm();function Vp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Tu(r,o,t,e))}function oy(n,t){return n.map((e,i)=>i==0?{}:di({},t,e))}function Tu(n,t,e,i){return di({},t==0?e:i,n)}function Tm(n,t,e){return t==null?Hr:[t,e]}var ay=Tm;function ly(n,t,e){return t==null?Hr:nl(t,e,Iu,!0)}function Am(n,t,e,i){return t==null?Hr:ol(t,e,n.scales[i].log,!1)}var cy=Am;function Rm(n,t,e,i){return t==null?Hr:Pu(t,e,n.scales[i].log,!1)}var hy=Rm;function uy(n,t,e,i,s){let r=Gi(vp(n),vp(t)),o=t-n,a=An(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Cs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Hp(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=vi((e=+s)*be))+"px"),[n,t,e]}function dy(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Fe(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ni(n,t,e){let i={mode:Me(n.mode,1)},s=i.mode;function r(x,b,P,I){let z=b.valToPct(x);return I+P*(b.dir==-1?1-z:z)}function o(x,b,P,I){let z=b.valToPct(x);return I+P*(b.dir==-1?z:1-z)}function a(x,b,P,I){return b.ori==0?r(x,b,P,I):o(x,b,P,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=gn(vx);if(n.id!=null&&(c.id=n.id),nn(c,n.class),n.title){let x=gn(Sx,c);x.textContent=n.title}let d=Tn("canvas"),u=i.ctx=d.getContext("2d"),h=gn(bx,c);er("click",h,x=>{x.target===g&&(Be!=Rr||Xe!=Cr)&&Ii.click(i,x)},!0);let f=i.under=gn(wx,h);h.appendChild(d);let g=i.over=gn(Ex,h);n=Gr(n);let _=+Me(n.pxAlign,1),m=kp(_);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?Vp(n.series||[],Ip,Up,!1):oy(n.series||[null],Fp),A=i.axes=Vp(n.axes||[],Pp,Np,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=pe(x.fill||null),x.dir=Me(x.dir,-1)});let T=s==2?y[1].facets[0].scale:y[0].scale,v={axes:rs,series:ue},E=(n.drawOrder||["axes","series"]).map(x=>v[x]);function k(x){let b=x.distr==3?P=>as(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>fu(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let I=b(P),{_min:z,_max:K}=x,at=K-z;return(I-z)/at}}function D(x){let b=M[x];if(b==null){let P=(n.scales||$o)[x]||$o;if(P.from!=null){D(P.from);let I=di({},M[P.from],P,{key:x});I.valToPct=k(I),M[x]=I}else{b=M[x]=di({},x==T?gm:Yv,P),b.key=x;let I=b.time,z=b.range,K=Rs(z);if((x!=T||s==2&&!I)&&(K&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?gp:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?gp:{mode:1,hard:z[1],soft:z[1]}},K=!1),!K&&ll(z))){let at=z;z=(ft,yt,Nt)=>yt==null?Hr:nl(yt,Nt,at)}b.range=pe(z||(I?ay:x==T?b.distr==3?cy:b.distr==4?hy:Tm:b.distr==3?Am:b.distr==4?Rm:ly)),b.auto=pe(K?!1:b.auto),b.clamp=pe(b.clamp||qv),b._min=b._max=null,b.valToPct=k(b)}}}D("x"),D("y"),s==1&&y.forEach(x=>{D(x.scale)}),A.forEach(x=>{D(x.scale)});for(let x in n.scales)D(x);let L=M[T],G=L.distr,W,N;L.ori==0?(nn(c,yx),W=r,N=o):(nn(c,Mx),W=o,N=r);let V={};for(let x in M){let b=M[x];(b.min!=null||b.max!=null)&&(V[x]={min:b.min,max:b.max},b.min=b.max=null)}let X=n.tzDate||(x=>new Date(vi(x/p))),O=n.fmtDate||Du,lt=p==1?yv(X):bv(X),Z=Ap(X,Tp(p==1?vv:Sv,O)),Q=Cp(X,Rp(Ev,O)),st=[],dt=i.legend=di({},Rv,n.legend),ut=i.cursor=di({},Dv,{drag:{y:s==2}},n.cursor),tt=dt.show,mt=ut.show,xt=dt.markers;dt.idxs=st,xt.width=pe(xt.width),xt.dash=pe(xt.dash),xt.stroke=pe(xt.stroke),xt.fill=pe(xt.fill);let At,St,Gt,ie=[],Vt=[],ce,re=!1,te={};if(dt.live){let x=y[1]?y[1].values:null;re=x!=null,ce=re?x(i,1,0):{_:0};for(let b in ce)te[b]=Ru}if(tt)if(At=Tn("table",Ix,c),Gt=Tn("tbody",null,At),dt.mount(i,At),re){St=Tn("thead",null,At,Gt);let x=Tn("tr",null,St);Tn("th",null,x);for(var We in ce)Tn("th",np,x).textContent=We}else nn(At,Nx),dt.live&&nn(At,Lx);let Ue={show:!0},oi={show:!1};function Ce(x,b){if(b==0&&(re||!dt.live||s==2))return Hr;let P=[],I=Tn("tr",Dx,Gt,Gt.childNodes[b]);nn(I,x.class),x.show||nn(I,tr);let z=Tn("th",null,I);if(xt.show){let ft=gn(Fx,z);if(b>0){let yt=xt.width(i,b);yt&&(ft.style.border=yt+"px "+xt.dash(i,b)+" "+xt.stroke(i,b)),ft.style.background=xt.fill(i,b)}}let K=gn(np,z);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,b>0&&(xt.show||(K.style.color=x.width>0?xt.stroke(i,b):xt.fill(i,b)),ve("click",z,ft=>{if(ut._lock)return;Zt(ft);let yt=y.indexOf(x);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Nt=y.some((Dt,Ut)=>Ut>0&&Ut!=yt&&Dt.show);y.forEach((Dt,Ut)=>{Ut>0&&Vn(Ut,Nt?Ut==yt?Ue:oi:Ue,!0,ui.setSeries)})}else Vn(yt,{show:!x.show},!0,ui.setSeries)},!1),Kt&&ve(ap,z,ft=>{ut._lock||(Zt(ft),Vn(y.indexOf(x),Ir,!0,ui.setSeries))},!1));for(var at in ce){let ft=Tn("td",Ux,I);ft.textContent="--",P.push(ft)}return[I,P]}let wi=new Map;function ve(x,b,P,I=!0){let z=wi.get(b)||{},K=ut.bind[x](i,b,P,I);K&&(er(x,b,z[x]=K),wi.set(b,z))}function gi(x,b,P){let I=wi.get(b)||{};for(let z in I)(x==null||z==x)&&(yu(z,b,I[z]),delete I[z]);x==null&&wi.delete(b)}let je=0,ai=0,U=0,Ct=0,$t=0,ne=0,bt=$t,Le=ne,zt=U,Xt=Ct,C=0,S=0,$=0,ht=0;i.bbox={};let ot=!1,_t=!1,vt=!1,et=!1,nt=!1,pt=!1;function F(x,b,P){(P||x!=i.width||b!=i.height)&&rt(x,b),oe(!1),vt=!0,_t=!0,Di()}function rt(x,b){i.width=je=U=x,i.height=ai=Ct=b,$t=ne=0,Mt(),Ht();let P=i.bbox;C=P.left=js($t*be,.5),S=P.top=js(ne*be,.5),$=P.width=js(U*be,.5),ht=P.height=js(Ct*be,.5)}let it=3;function wt(){let x=!1,b=0;for(;!x;){b++;let P=Er(b),I=zn(b);x=b==it||P&&I,x||(rt(i.width,i.height),_t=!0)}}function gt({width:x,height:b}){F(x,b)}i.setSize=gt;function Mt(){let x=!1,b=!1,P=!1,I=!1;A.forEach((z,K)=>{if(z.show&&z._show){let{side:at,_size:ft}=z,yt=at%2,Nt=z.label!=null?z.labelSize:0,Dt=ft+Nt;Dt>0&&(yt?(U-=Dt,at==3?($t+=Dt,I=!0):P=!0):(Ct-=Dt,at==0?(ne+=Dt,x=!0):b=!0))}}),kn[0]=x,kn[1]=P,kn[2]=b,kn[3]=I,U-=Sn[1]+Sn[3],$t+=Sn[3],Ct-=Sn[2]+Sn[0],ne+=Sn[0]}function Ht(){let x=$t+U,b=ne+Ct,P=$t,I=ne;function z(K,at){switch(K){case 1:return x+=at,x-at;case 2:return b+=at,b-at;case 3:return P-=at,P+at;case 0:return I-=at,I+at}}A.forEach((K,at)=>{if(K.show&&K._show){let ft=K.side;K._pos=z(ft,K._size),K.label!=null&&(K._lpos=z(ft,K.labelSize))}})}if(ut.dataIdx==null){let x=ut.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let P=x.prox=pe(x.prox),I=x.bias??=0;ut.dataIdx=(z,K,at,ft)=>{if(K==0)return at;let yt=at,Nt=P(z,K,at,ft)??De,Dt=Nt>=0&&Nt<De,Ut=L.ori==0?U:Ct,ee=ut.left,Se=t[0],ye=t[K];if(b.has(ye[at])){yt=null;let de=null,qt=null,Wt;if(I==0||I==-1)for(Wt=at;de==null&&Wt-- >0;)b.has(ye[Wt])||(de=Wt);if(I==0||I==1)for(Wt=at;qt==null&&Wt++<ye.length;)b.has(ye[Wt])||(qt=Wt);if(de!=null||qt!=null)if(Dt){let Ve=de==null?-1/0:W(Se[de],L,Ut,0),ei=qt==null?1/0:W(Se[qt],L,Ut,0),Ri=ee-Ve,Pe=ei-ee;Ri<=Pe?Ri<=Nt&&(yt=de):Pe<=Nt&&(yt=qt)}else yt=qt==null?de:de==null?qt:at-de<=qt-at?de:qt}else Dt&&yi(ee-W(Se[at],L,Ut,0))>Nt&&(yt=null);return yt}}let Zt=x=>{ut.event=x};ut.idxs=st,ut._lock=!1;let ct=ut.points;ct.show=pe(ct.show),ct.size=pe(ct.size),ct.stroke=pe(ct.stroke),ct.width=pe(ct.width),ct.fill=pe(ct.fill);let Ot=i.focus=di({},n.focus||{alpha:.3},ut.focus),Kt=Ot.prox>=0,Rt=Kt&&ct.one,se=[],ke=[],ki=[];function Ro(x,b){let P=ct.show(i,b);if(P instanceof HTMLElement)return nn(P,Px),nn(P,x.class),Xn(P,-10,-10,U,Ct),g.insertBefore(P,se[b]),P}function Sr(x,b){if(s==1||b>0){let P=s==1&&M[x.scale].time,I=x.value;x.value=P?Sp(I)?Cp(X,Rp(I,O)):I||Q:I||Wv,x.label=x.label||(P?Uv:Fv)}if(Rt||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||sy||Yx,x.fillTo=pe(x.fillTo||Zv),x.pxAlign=+Me(x.pxAlign,_),x.pxRound=kp(x.pxAlign),x.stroke=pe(x.stroke||null),x.fill=pe(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=Xv(Gi(1,x.width),1),I=x.points=di({},{size:P,width:Gi(1,P*.2),stroke:x.stroke,space:P*2,paths:ry,_stroke:null,_fill:null},x.points);I.show=pe(I.show),I.filter=pe(I.filter),I.fill=pe(I.fill),I.stroke=pe(I.stroke),I.paths=pe(I.paths),I.pxAlign=x.pxAlign}if(tt){let P=Ce(x,b);ie.splice(b,0,P[0]),Vt.splice(b,0,P[1]),dt.values.push(null)}if(mt){st.splice(b,0,null);let P=null;Rt?b==0&&(P=Ro(x,b)):b>0&&(P=Ro(x,b)),se.splice(b,0,P),ke.splice(b,0,0),ki.splice(b,0,0)}Ai("addSeries",b)}function Jh(x,b){b=b??y.length,x=s==1?Tu(x,b,Ip,Up):Tu(x,b,{},Fp),y.splice(b,0,x),Sr(y[b],b)}i.addSeries=Jh;function za(x){if(y.splice(x,1),tt){dt.values.splice(x,1),Vt.splice(x,1);let b=ie.splice(x,1)[0];gi(null,b.firstChild),b.remove()}mt&&(st.splice(x,1),se.splice(x,1)[0].remove(),ke.splice(x,1),ki.splice(x,1)),Ai("delSeries",x)}i.delSeries=za;let kn=[!1,!1,!1,!1];function is(x,b){if(x._show=x.show,x.show){let P=x.side%2,I=M[x.scale];I==null&&(x.scale=P?y[1].scale:T,I=M[x.scale]);let z=I.time;x.size=pe(x.size),x.space=pe(x.space),x.rotate=pe(x.rotate),Rs(x.incrs)&&x.incrs.forEach(at=>{!Cs.has(at)&&Cs.set(at,Jp(at))}),x.incrs=pe(x.incrs||(I.distr==2?gv:z?p==1?xv:Mv:Qs)),x.splits=pe(x.splits||(z&&I.distr==1?lt:I.distr==3?Su:I.distr==4?Bv:kv)),x.stroke=pe(x.stroke),x.grid.stroke=pe(x.grid.stroke),x.ticks.stroke=pe(x.ticks.stroke),x.border.stroke=pe(x.border.stroke);let K=x.values;x.values=Rs(K)&&!Rs(K[0])?pe(K):z?Rs(K)?Ap(X,Tp(K,O)):Sp(K)?wv(X,K):K||Z:K||Ov,x.filter=pe(x.filter||(I.distr>=3&&I.log==10?Hv:I.distr==3&&I.log==2?Gv:Zp)),x.font=Hp(x.font),x.labelFont=Hp(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(kn[b]=!0,x._el=gn(Tx,h))}}function ns(x,b,P,I){let[z,K,at,ft]=P,yt=b%2,Nt=0;return yt==0&&(ft||K)&&(Nt=b==0&&!z||b==2&&!at?vi(Pp.size/3):0),yt==1&&(z||at)&&(Nt=b==1&&!K||b==3&&!ft?vi(Np.size/2):0),Nt}let Co=i.padding=(n.padding||[ns,ns,ns,ns]).map(x=>pe(Me(x,ns))),Sn=i._padding=Co.map((x,b)=>x(i,b,kn,0)),Qe,ni=null,si=null,Bn=s==1?y[0].idxs:null,Ji=null,Ss=!1;function Po(x,b){if(t=x??[],i.data=i._data=t,s==2){Qe=0;for(let P=1;P<y.length;P++)Qe+=t[P][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Ji=t[0],Qe=Ji.length;let P=t;if(G==2){P=t.slice();let I=P[0]=Array(Qe);for(let z=0;z<Qe;z++)I[z]=z}i._data=t=P}if(oe(!0),Ai("setData"),G==2&&(vt=!0),b!==!1){let P=L;P.auto(i,Ss)?Io():Es(T,P.min,P.max),et=et||ut.left>=0,pt=!0,Di()}}i.setData=Po;function Io(){Ss=!0;let x,b;s==1&&(Qe>0?(ni=Bn[0]=0,si=Bn[1]=Qe-1,x=t[0][ni],b=t[0][si],G==2?(x=ni,b=si):x==b&&(G==3?[x,b]=ol(x,x,L.log,!1):G==4?[x,b]=Pu(x,x,L.log,!1):L.time?b=x+vi(86400/p):[x,b]=nl(x,b,Iu,!0))):(ni=Bn[0]=x=null,si=Bn[1]=b=null)),Es(T,x,b)}let br,bs,wr,w,B,j,q,Y,Et,Pt;function Tt(x,b,P,I,z,K){x??=rp,P??=Nu,I??="butt",z??=rp,K??="round",x!=br&&(u.strokeStyle=br=x),z!=bs&&(u.fillStyle=bs=z),b!=wr&&(u.lineWidth=wr=b),K!=B&&(u.lineJoin=B=K),I!=j&&(u.lineCap=j=I),P!=w&&u.setLineDash(w=P)}function It(x,b,P,I){b!=bs&&(u.fillStyle=bs=b),x!=q&&(u.font=q=x),P!=Y&&(u.textAlign=Y=P),I!=Et&&(u.textBaseline=Et=I)}function Bt(x,b,P,I,z=0){if(I.length>0&&x.auto(i,Ss)&&(b==null||b.min==null)){let K=Me(ni,0),at=Me(si,I.length-1),ft=P.min==null?Hx(I,K,at,z,x.distr==3):[P.min,P.max];x.min=Rn(x.min,P.min=ft[0]),x.max=Gi(x.max,P.max=ft[1])}}let Jt={min:null,max:null};function he(){for(let I in M){let z=M[I];V[I]==null&&(z.min==null||V[T]!=null&&z.auto(i,Ss))&&(V[I]=Jt)}for(let I in M){let z=M[I];V[I]==null&&z.from!=null&&V[z.from]!=null&&(V[I]=Jt)}V[T]!=null&&oe(!0);let x={};for(let I in V){let z=V[I];if(z!=null){let K=x[I]=Gr(M[I],Jx);if(z.min!=null)di(K,z);else if(I!=T||s==2)if(Qe==0&&K.from==null){let at=K.range(i,null,null,I);K.min=at[0],K.max=at[1]}else K.min=De,K.max=-De}}if(Qe>0){y.forEach((I,z)=>{if(s==1){let K=I.scale,at=V[K];if(at==null)return;let ft=x[K];if(z==0){let yt=ft.range(i,ft.min,ft.max,K);ft.min=yt[0],ft.max=yt[1],ni=An(ft.min,t[0]),si=An(ft.max,t[0]),si-ni>1&&(t[0][ni]<ft.min&&ni++,t[0][si]>ft.max&&si--),I.min=Ji[ni],I.max=Ji[si]}else I.show&&I.auto&&Bt(ft,at,I,t[z],I.sorted);I.idxs[0]=ni,I.idxs[1]=si}else if(z>0&&I.show&&I.auto){let[K,at]=I.facets,ft=K.scale,yt=at.scale,[Nt,Dt]=t[z],Ut=x[ft],ee=x[yt];Ut!=null&&Bt(Ut,V[ft],K,Nt,K.sorted),ee!=null&&Bt(ee,V[yt],at,Dt,at.sorted),I.min=at.min,I.max=at.max}});for(let I in x){let z=x[I],K=V[I];if(z.from==null&&(K==null||K.min==null)){let at=z.range(i,z.min==De?null:z.min,z.max==-De?null:z.max,I);z.min=at[0],z.max=at[1]}}}for(let I in x){let z=x[I];if(z.from!=null){let K=x[z.from];if(K.min==null)z.min=z.max=null;else{let at=z.range(i,K.min,K.max,I);z.min=at[0],z.max=at[1]}}}let b={},P=!1;for(let I in x){let z=x[I],K=M[I];if(K.min!=z.min||K.max!=z.max){K.min=z.min,K.max=z.max;let at=K.distr;K._min=at==3?as(K.min):at==4?fu(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?as(K.max):at==4?fu(K.max,K.asinh):at==100?K.fwd(K.max):K.max,b[I]=P=!0}}if(P){y.forEach((I,z)=>{s==2?z>0&&b.y&&(I._paths=null):b[I.scale]&&(I._paths=null)});for(let I in b)vt=!0,Ai("setScale",I);mt&&ut.left>=0&&(et=pt=!0)}for(let I in V)V[I]=null}function kt(x){let b=Mu(ni-1,0,Qe-1),P=Mu(si+1,0,Qe-1);for(;x[b]==null&&b>0;)b--;for(;x[P]==null&&P<Qe-1;)P++;return[b,P]}function ue(){if(Qe>0){let x=y.some(b=>b._focus)&&Pt!=Ot.alpha;x&&(u.globalAlpha=Pt=Ot.alpha),y.forEach((b,P)=>{if(P>0&&b.show&&(Ye(P,!1),Ye(P,!0),b._paths==null)){let I=Pt;Pt!=b.alpha&&(u.globalAlpha=Pt=b.alpha);let z=s==2?[0,t[P][0].length-1]:kt(t[P]);b._paths=b.paths(i,P,z[0],z[1]),Pt!=I&&(u.globalAlpha=Pt=I)}}),y.forEach((b,P)=>{if(P>0&&b.show){let I=Pt;Pt!=b.alpha&&(u.globalAlpha=Pt=b.alpha),b._paths!=null&&Te(P,!1);{let z=b._paths!=null?b._paths.gaps:null,K=b.points.show(i,P,ni,si,z),at=b.points.filter(i,P,K,z);(K||at)&&(b.points._paths=b.points.paths(i,P,ni,si,at),Te(P,!0))}Pt!=I&&(u.globalAlpha=Pt=I),Ai("drawSeries",P)}}),x&&(u.globalAlpha=Pt=1)}}function Ye(x,b){let P=b?y[x].points:y[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function Te(x,b){let P=b?y[x].points:y[x],{stroke:I,fill:z,clip:K,flags:at,_stroke:ft=P._stroke,_fill:yt=P._fill,_width:Nt=P.width}=P._paths;Nt=Fe(Nt*be,3);let Dt=null,Ut=Nt%2/2;b&&yt==null&&(yt=Nt>0?"#fff":ft);let ee=P.pxAlign==1&&Ut>0;if(ee&&u.translate(Ut,Ut),!b){let Se=C-Nt/2,ye=S-Nt/2,de=$+Nt,qt=ht+Nt;Dt=new Path2D,Dt.rect(Se,ye,de,qt)}b?Ft(ft,Nt,P.dash,P.cap,yt,I,z,at,K):Ae(x,ft,Nt,P.dash,P.cap,yt,I,z,at,Dt,K),ee&&u.translate(-Ut,-Ut)}function Ae(x,b,P,I,z,K,at,ft,yt,Nt,Dt){let Ut=!1;yt!=0&&R.forEach((ee,Se)=>{if(ee.series[0]==x){let ye=y[ee.series[1]],de=t[ee.series[1]],qt=(ye._paths||$o).band;Rs(qt)&&(qt=ee.dir==1?qt[0]:qt[1]);let Wt,Ve=null;ye.show&&qt&&Wx(de,ni,si)?(Ve=ee.fill(i,Se)||K,Wt=ye._paths.clip):qt=null,Ft(b,P,I,z,Ve,at,ft,yt,Nt,Dt,Wt,qt),Ut=!0}}),Ut||Ft(b,P,I,z,K,at,ft,yt,Nt,Dt)}let _i=Wr|wu;function Ft(x,b,P,I,z,K,at,ft,yt,Nt,Dt,Ut){Tt(x,b,P,I,z),(yt||Nt||Ut)&&(u.save(),yt&&u.clip(yt),Nt&&u.clip(Nt)),Ut?(ft&_i)==_i?(u.clip(Ut),Dt&&u.clip(Dt),fe(z,at),li(x,K,b)):ft&wu?(fe(z,at),u.clip(Ut),li(x,K,b)):ft&Wr&&(u.save(),u.clip(Ut),Dt&&u.clip(Dt),fe(z,at),u.restore(),li(x,K,b)):(fe(z,at),li(x,K,b)),(yt||Nt||Ut)&&u.restore()}function li(x,b,P){P>0&&(b instanceof Map?b.forEach((I,z)=>{u.strokeStyle=br=z,u.stroke(I)}):b!=null&&x&&u.stroke(b))}function fe(x,b){b instanceof Map?b.forEach((P,I)=>{u.fillStyle=bs=I,u.fill(P)}):b!=null&&x&&u.fill(b)}function ss(x,b,P,I){let z=A[x],K;if(I<=0)K=[0,0];else{let at=z._space=z.space(i,x,b,P,I),ft=z._incrs=z.incrs(i,x,b,P,I,at);K=uy(b,P,ft,I,at)}return z._found=K}function ci(x,b,P,I,z,K,at,ft,yt,Nt){let Dt=at%2/2;_==1&&u.translate(Dt,Dt),Tt(ft,at,yt,Nt,ft),u.beginPath();let Ut,ee,Se,ye,de=z+(I==0||I==3?-K:K);P==0?(ee=z,ye=de):(Ut=z,Se=de);for(let qt=0;qt<x.length;qt++)b[qt]!=null&&(P==0?Ut=Se=x[qt]:ee=ye=x[qt],u.moveTo(Ut,ee),u.lineTo(Se,ye));u.stroke(),_==1&&u.translate(-Dt,-Dt)}function Er(x){let b=!0;return A.forEach((P,I)=>{if(!P.show)return;let z=M[P.scale];if(z.min==null){P._show&&(b=!1,P._show=!1,oe(!1));return}else P._show||(b=!1,P._show=!0,oe(!1));let K=P.side,at=K%2,{min:ft,max:yt}=z,[Nt,Dt]=ss(I,ft,yt,at==0?U:Ct);if(Dt==0)return;let Ut=z.distr==2,ee=P._splits=P.splits(i,I,ft,yt,Nt,Dt,Ut),Se=z.distr==2?ee.map(Wt=>Ji[Wt]):ee,ye=z.distr==2?Ji[ee[1]]-Ji[ee[0]]:Nt,de=P._values=P.values(i,P.filter(i,Se,I,Dt,ye),I,Dt,ye);P._rotate=K==2?P.rotate(i,de,I,Dt):0;let qt=P._size;P._size=_n(P.size(i,de,I,x)),qt!=null&&P._size!=qt&&(b=!1)}),b}function zn(x){let b=!0;return Co.forEach((P,I)=>{let z=P(i,I,kn,x);z!=Sn[I]&&(b=!1),Sn[I]=z}),b}function rs(){for(let x=0;x<A.length;x++){let b=A[x];if(!b.show||!b._show)continue;let P=b.side,I=P%2,z,K,at=b.stroke(i,x),ft=P==0||P==3?-1:1,[yt,Nt]=b._found;if(b.label!=null){let Vi=b.labelGap*ft,tn=vi((b._lpos+Vi)*be);It(b.labelFont[0],at,"center",P==2?"top":sp),u.save(),I==1?(z=K=0,u.translate(tn,vi(S+ht/2)),u.rotate((P==3?-el:el)/2)):(z=vi(C+$/2),K=tn);let Zs=qp(b.label)?b.label(i,x,yt,Nt):b.label;u.fillText(Zs,z,K),u.restore()}if(Nt==0)continue;let Dt=M[b.scale],Ut=I==0?$:ht,ee=I==0?C:S,Se=b._splits,ye=Dt.distr==2?Se.map(Vi=>Ji[Vi]):Se,de=Dt.distr==2?Ji[Se[1]]-Ji[Se[0]]:yt,qt=b.ticks,Wt=b.border,Ve=qt.show?qt.size:0,ei=vi(Ve*be),Ri=vi((b.alignTo==2?b._size-Ve-b.gap:b.gap)*be),Pe=b._rotate*-el/180,ii=m(b._pos*be),ji=(ei+Ri)*ft,zi=ii+ji;K=I==0?zi:0,z=I==1?zi:0;let fn=b.font[0],bn=b.align==1?kr:b.align==2?hu:Pe>0?kr:Pe<0?hu:I==0?"center":P==3?hu:kr,Gn=Pe||I==1?"middle":P==2?"top":sp;It(fn,at,bn,Gn);let Qi=b.font[1]*b.lineGap,pn=Se.map(Vi=>m(a(Vi,Dt,Ut,ee))),wn=b._values;for(let Vi=0;Vi<wn.length;Vi++){let tn=wn[Vi];if(tn!=null){I==0?z=pn[Vi]:K=pn[Vi],tn=""+tn;let Zs=tn.indexOf(`
`)==-1?[tn]:tn.split(/\n/gm);for(let Hi=0;Hi<Zs.length;Hi++){let $f=Zs[Hi];Pe?(u.save(),u.translate(z,K+Hi*Qi),u.rotate(Pe),u.fillText($f,0,0),u.restore()):u.fillText($f,z,K+Hi*Qi)}}}qt.show&&ci(pn,qt.filter(i,ye,x,Nt,de),I,P,ii,ei,Fe(qt.width*be,3),qt.stroke(i,x),qt.dash,qt.cap);let Wn=b.grid;Wn.show&&ci(pn,Wn.filter(i,ye,x,Nt,de),I,I==0?2:1,I==0?S:C,I==0?ht:$,Fe(Wn.width*be,3),Wn.stroke(i,x),Wn.dash,Wn.cap),Wt.show&&ci([ii],[1],I==0?1:0,I==0?1:2,I==1?S:C,I==1?ht:$,Fe(Wt.width*be,3),Wt.stroke(i,x),Wt.dash,Wt.cap)}Ai("drawAxes")}function oe(x){y.forEach((b,P)=>{P>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(I=>{I.min=null,I.max=null})))})}let ti=!1,Bi=!1,Re=[];function hi(){Bi=!1;for(let x=0;x<Re.length;x++)Ai(...Re[x]);Re.length=0}function Di(){ti||(sv(Rf),ti=!0)}function Va(x,b=!1){ti=!0,Bi=b,x(i),Rf(),b&&Re.length>0&&queueMicrotask(hi)}i.batch=Va;function Rf(){if(ot&&(he(),ot=!1),vt&&(wt(),vt=!1),_t){if(He(f,kr,$t),He(f,"top",ne),He(f,Ho,U),He(f,Go,Ct),He(g,kr,$t),He(g,"top",ne),He(g,Ho,U),He(g,Go,Ct),He(h,Ho,je),He(h,Go,ai),d.width=vi(je*be),d.height=vi(ai*be),A.forEach(({_el:x,_show:b,_size:P,_pos:I,side:z})=>{if(x!=null)if(b){let K=z===3||z===0?P:0,at=z%2==1;He(x,at?"left":"top",I-K),He(x,at?"width":"height",P),He(x,at?"top":"left",at?ne:$t),He(x,at?"height":"width",at?Ct:U),vu(x,tr)}else nn(x,tr)}),br=bs=wr=B=j=q=Y=Et=w=null,Pt=1,Do(!0),$t!=bt||ne!=Le||U!=zt||Ct!=Xt){oe(!1);let x=U/zt,b=Ct/Xt;if(mt&&!et&&ut.left>=0){ut.left*=x,ut.top*=b,Tr&&Xn(Tr,vi(ut.left),0,U,Ct),Ar&&Xn(Ar,0,vi(ut.top),U,Ct);for(let P=0;P<se.length;P++){let I=se[P];I!=null&&(ke[P]*=x,ki[P]*=b,Xn(I,_n(ke[P]),_n(ki[P]),U,Ct))}}if(ze.show&&!nt&&ze.left>=0&&ze.width>0){ze.left*=x,ze.width*=x,ze.top*=b,ze.height*=b;for(let P in nu)He(Pr,P,ze[P])}bt=$t,Le=ne,zt=U,Xt=Ct}Ai("setSize"),_t=!1}je>0&&ai>0&&(u.clearRect(0,0,d.width,d.height),Ai("drawClear"),E.forEach(x=>x()),Ai("draw")),ze.show&&nt&&(Ha(ze),nt=!1),mt&&et&&(Ys(null,!0,!1),et=!1),dt.show&&dt.live&&pt&&(eu(),pt=!1),l||(l=!0,i.status=1,Ai("ready")),Ss=!1,ti=!1}i.redraw=(x,b)=>{vt=b||!1,x!==!1?Es(T,L.min,L.max):Di()};function jh(x,b){let P=M[x];if(P.from==null){if(Qe==0){let I=P.range(i,b.min,b.max,x);b.min=I[0],b.max=I[1]}if(b.min>b.max){let I=b.min;b.min=b.max,b.max=I}if(Qe>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==T&&P.distr==2&&Qe>0&&(b.min=An(b.min,t[0]),b.max=An(b.max,t[0]),b.min==b.max&&b.max++),V[x]=b,ot=!0,Di()}}i.setScale=jh;let Qh,tu,Tr,Ar,Cf,Pf,Rr,Cr,If,Lf,Be,Xe,ws=!1,Ii=ut.drag,Ei=Ii.x,Ti=Ii.y;mt&&(ut.x&&(Qh=gn(Rx,g)),ut.y&&(tu=gn(Cx,g)),L.ori==0?(Tr=Qh,Ar=tu):(Tr=tu,Ar=Qh),Be=ut.left,Xe=ut.top);let ze=i.select=di({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Pr=ze.show?gn(Ax,ze.over?g:f):null;function Ha(x,b){if(ze.show){for(let P in x)ze[P]=x[P],P in nu&&He(Pr,P,x[P]);b!==!1&&Ai("setSelect")}}i.setSelect=Ha;function P_(x){if(y[x].show)tt&&vu(ie[x],tr);else if(tt&&nn(ie[x],tr),mt){let P=Rt?se[0]:se[x];P!=null&&Xn(P,-10,-10,U,Ct)}}function Es(x,b,P){jh(x,{min:b,max:P})}function Vn(x,b,P,I){b.focus!=null&&F_(x),b.show!=null&&y.forEach((z,K)=>{K>0&&(x==K||x==null)&&(z.show=b.show,P_(K),s==2?(Es(z.facets[0].scale,null,null),Es(z.facets[1].scale,null,null)):Es(z.scale,null,null),Di())}),P!==!1&&Ai("setSeries",x,b),I&&Fo("setSeries",i,x,b)}i.setSeries=Vn;function I_(x,b){di(R[x],b)}function L_(x,b){x.fill=pe(x.fill||null),x.dir=Me(x.dir,-1),b=b??R.length,R.splice(b,0,x)}function N_(x){x==null?R.length=0:R.splice(x,1)}i.addBand=L_,i.setBand=I_,i.delBand=N_;function D_(x,b){y[x].alpha=b,mt&&se[x]!=null&&(se[x].style.opacity=b),tt&&ie[x]&&(ie[x].style.opacity=b)}let os,Ts,qs,Ir={focus:!0};function F_(x){if(x!=qs){let b=x==null,P=Ot.alpha!=1;y.forEach((I,z)=>{if(s==1||z>0){let K=b||z==0||z==x;I._focus=b?null:K,P&&D_(z,K?1:Ot.alpha)}}),qs=x,P&&Di()}}tt&&Kt&&ve(lp,At,x=>{ut._lock||(Zt(x),qs!=null&&Vn(null,Ir,!0,ui.setSeries))});function Hn(x,b,P){let I=M[b];P&&(x=x/be-(I.ori==1?ne:$t));let z=U;I.ori==1&&(z=Ct,x=z-x),I.dir==-1&&(x=z-x);let K=I._min,at=I._max,ft=x/z,yt=K+(at-K)*ft,Nt=I.distr;return Nt==3?Vr(10,yt):Nt==4?$x(yt,I.asinh):Nt==100?I.bwd(yt):yt}function U_(x,b){let P=Hn(x,T,b);return An(P,t[0],ni,si)}i.valToIdx=x=>An(x,t[0]),i.posToIdx=U_,i.posToVal=Hn,i.valToPos=(x,b,P)=>M[b].ori==0?r(x,M[b],P?$:U,P?C:0):o(x,M[b],P?ht:Ct,P?S:0),i.setCursor=(x,b,P)=>{Be=x.left,Xe=x.top,Ys(null,b,P)};function Nf(x,b){He(Pr,kr,ze.left=x),He(Pr,Ho,ze.width=b)}function Df(x,b){He(Pr,"top",ze.top=x),He(Pr,Go,ze.height=b)}let Lo=L.ori==0?Nf:Df,No=L.ori==1?Nf:Df;function O_(){if(tt&&dt.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&re)continue;let b=dt.values[x],P=0;for(let I in b)Vt[x][P++].firstChild.nodeValue=b[I]}}function eu(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((P,I)=>{st[I]=P}):Kx(x.idx)||st.fill(x.idx),dt.idx=st[0]),tt&&dt.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!re)&&k_(P,st[P]);O_()}pt=!1,b!==!1&&Ai("setLegend")}i.setLegend=eu;function k_(x,b){let P=y[x],I=x==0&&G==2?Ji:t[x],z;re?z=P.values(i,x,b)??te:(z=P.value(i,b==null?null:I[b],x,b),z=z==null?te:{_:z}),dt.values[x]=z}function Ys(x,b,P){If=Be,Lf=Xe,[Be,Xe]=ut.move(i,Be,Xe),ut.left=Be,ut.top=Xe,mt&&(Tr&&Xn(Tr,vi(Be),0,U,Ct),Ar&&Xn(Ar,0,vi(Xe),U,Ct));let I,z=ni>si;os=De,Ts=null;let K=L.ori==0?U:Ct,at=L.ori==1?U:Ct;if(Be<0||Qe==0||z){I=ut.idx=null;for(let ft=0;ft<y.length;ft++){let yt=se[ft];yt!=null&&Xn(yt,-10,-10,U,Ct)}Kt&&Vn(null,Ir,!0,x==null&&ui.setSeries),dt.live&&(st.fill(I),pt=!0)}else{let ft,yt,Nt;s==1&&(ft=L.ori==0?Be:Xe,yt=Hn(ft,T),I=ut.idx=An(yt,t[0],ni,si),Nt=W(t[0][I],L,K,0));let Dt=-10,Ut=-10,ee=0,Se=0,ye=!0,de="",qt="";for(let Wt=s==2?1:0;Wt<y.length;Wt++){let Ve=y[Wt],ei=st[Wt],Ri=ei==null?null:s==1?t[Wt][ei]:t[Wt][1][ei],Pe=ut.dataIdx(i,Wt,I,yt),ii=Pe==null?null:s==1?t[Wt][Pe]:t[Wt][1][Pe];if(pt=pt||ii!=Ri||Pe!=ei,st[Wt]=Pe,Wt>0&&Ve.show){let ji=Pe==null?-10:Pe==I?Nt:W(s==1?t[0][Pe]:t[Wt][0][Pe],L,K,0),zi=ii==null?-10:N(ii,s==1?M[Ve.scale]:M[Ve.facets[1].scale],at,0);if(Kt&&ii!=null){let fn=L.ori==1?Be:Xe,bn=yi(Ot.dist(i,Wt,Pe,zi,fn));if(bn<os){let Gn=Ot.bias;if(Gn!=0){let Qi=Hn(fn,Ve.scale),pn=ii>=0?1:-1,wn=Qi>=0?1:-1;wn==pn&&(wn==1?Gn==1?ii>=Qi:ii<=Qi:Gn==1?ii<=Qi:ii>=Qi)&&(os=bn,Ts=Wt)}else os=bn,Ts=Wt}}if(pt||Rt){let fn,bn;L.ori==0?(fn=ji,bn=zi):(fn=zi,bn=ji);let Gn,Qi,pn,wn,Wn,Vi,tn=!0,Zs=ct.bbox;if(Zs!=null){tn=!1;let Hi=Zs(i,Wt);pn=Hi.left,wn=Hi.top,Gn=Hi.width,Qi=Hi.height}else pn=fn,wn=bn,Gn=Qi=ct.size(i,Wt);if(Vi=ct.fill(i,Wt),Wn=ct.stroke(i,Wt),Rt)Wt==Ts&&os<=Ot.prox&&(Dt=pn,Ut=wn,ee=Gn,Se=Qi,ye=tn,de=Vi,qt=Wn);else{let Hi=se[Wt];Hi!=null&&(ke[Wt]=pn,ki[Wt]=wn,mp(Hi,Gn,Qi,tn),fp(Hi,Vi,Wn),Xn(Hi,_n(pn),_n(wn),U,Ct))}}}}if(Rt){let Wt=Ot.prox,Ve=qs==null?os<=Wt:os>Wt||Ts!=qs;if(pt||Ve){let ei=se[0];ei!=null&&(ke[0]=Dt,ki[0]=Ut,mp(ei,ee,Se,ye),fp(ei,de,qt),Xn(ei,_n(Dt),_n(Ut),U,Ct))}}}if(ze.show&&ws)if(x!=null){let[ft,yt]=ui.scales,[Nt,Dt]=ui.match,[Ut,ee]=x.cursor.sync.scales,Se=x.cursor.drag;if(Ei=Se._x,Ti=Se._y,Ei||Ti){let{left:ye,top:de,width:qt,height:Wt}=x.select,Ve=x.scales[Ut].ori,ei=x.posToVal,Ri,Pe,ii,ji,zi,fn=ft!=null&&Nt(ft,Ut),bn=yt!=null&&Dt(yt,ee);fn&&Ei?(Ve==0?(Ri=ye,Pe=qt):(Ri=de,Pe=Wt),ii=M[ft],ji=W(ei(Ri,Ut),ii,K,0),zi=W(ei(Ri+Pe,Ut),ii,K,0),Lo(Rn(ji,zi),yi(zi-ji))):Lo(0,K),bn&&Ti?(Ve==1?(Ri=ye,Pe=qt):(Ri=de,Pe=Wt),ii=M[yt],ji=N(ei(Ri,ee),ii,at,0),zi=N(ei(Ri+Pe,ee),ii,at,0),No(Rn(ji,zi),yi(zi-ji))):No(0,at)}else su()}else{let ft=yi(If-Cf),yt=yi(Lf-Pf);if(L.ori==1){let ee=ft;ft=yt,yt=ee}Ei=Ii.x&&ft>=Ii.dist,Ti=Ii.y&&yt>=Ii.dist;let Nt=Ii.uni;Nt!=null?Ei&&Ti&&(Ei=ft>=Nt,Ti=yt>=Nt,!Ei&&!Ti&&(yt>ft?Ti=!0:Ei=!0)):Ii.x&&Ii.y&&(Ei||Ti)&&(Ei=Ti=!0);let Dt,Ut;Ei&&(L.ori==0?(Dt=Rr,Ut=Be):(Dt=Cr,Ut=Xe),Lo(Rn(Dt,Ut),yi(Ut-Dt)),Ti||No(0,at)),Ti&&(L.ori==1?(Dt=Rr,Ut=Be):(Dt=Cr,Ut=Xe),No(Rn(Dt,Ut),yi(Ut-Dt)),Ei||Lo(0,K)),!Ei&&!Ti&&(Lo(0,0),No(0,0))}if(Ii._x=Ei,Ii._y=Ti,x==null){if(P){if(Xf!=null){let[ft,yt]=ui.scales;ui.values[0]=ft!=null?Hn(L.ori==0?Be:Xe,ft):null,ui.values[1]=yt!=null?Hn(L.ori==1?Be:Xe,yt):null}Fo(uu,i,Be,Xe,U,Ct,I)}if(Kt){let ft=P&&ui.setSeries,yt=Ot.prox;qs==null?os<=yt&&Vn(Ts,Ir,!0,ft):os>yt?Vn(null,Ir,!0,ft):Ts!=qs&&Vn(Ts,Ir,!0,ft)}}pt&&(dt.idx=I,eu()),b!==!1&&Ai("setCursor")}let As=null;Object.defineProperty(i,"rect",{get(){return As==null&&Do(!1),As}});function Do(x=!1){x?As=null:(As=g.getBoundingClientRect(),Ai("syncRect",As))}function Ff(x,b,P,I,z,K,at){ut._lock||ws&&x!=null&&x.movementX==0&&x.movementY==0||(iu(x,b,P,I,z,K,at,!1,x!=null),x!=null?Ys(null,!0,!0):Ys(b,!0,!1))}function iu(x,b,P,I,z,K,at,ft,yt){if(As==null&&Do(!1),Zt(x),x!=null)P=x.clientX-As.left,I=x.clientY-As.top;else{if(P<0||I<0){Be=-10,Xe=-10;return}let[Nt,Dt]=ui.scales,Ut=b.cursor.sync,[ee,Se]=Ut.values,[ye,de]=Ut.scales,[qt,Wt]=ui.match,Ve=b.axes[0].side%2==1,ei=L.ori==0?U:Ct,Ri=L.ori==1?U:Ct,Pe=Ve?K:z,ii=Ve?z:K,ji=Ve?I:P,zi=Ve?P:I;if(ye!=null?P=qt(Nt,ye)?a(ee,M[Nt],ei,0):-10:P=ei*(ji/Pe),de!=null?I=Wt(Dt,de)?a(Se,M[Dt],Ri,0):-10:I=Ri*(zi/ii),L.ori==1){let fn=P;P=I,I=fn}}yt&&(b==null||b.cursor.event.type==uu)&&((P<=1||P>=U-1)&&(P=js(P,U)),(I<=1||I>=Ct-1)&&(I=js(I,Ct))),ft?(Cf=P,Pf=I,[Rr,Cr]=ut.move(i,P,I)):(Be=P,Xe=I)}let nu={width:0,height:0,left:0,top:0};function su(){Ha(nu,!1)}let Uf,Of,kf,Bf;function zf(x,b,P,I,z,K,at){ws=!0,Ei=Ti=Ii._x=Ii._y=!1,iu(x,b,P,I,z,K,at,!0,!1),x!=null&&(ve(du,_u,Vf,!1),Fo(op,i,Rr,Cr,U,Ct,null));let{left:ft,top:yt,width:Nt,height:Dt}=ze;Uf=ft,Of=yt,kf=Nt,Bf=Dt}function Vf(x,b,P,I,z,K,at){ws=Ii._x=Ii._y=!1,iu(x,b,P,I,z,K,at,!1,!0);let{left:ft,top:yt,width:Nt,height:Dt}=ze,Ut=Nt>0||Dt>0,ee=Uf!=ft||Of!=yt||kf!=Nt||Bf!=Dt;if(Ut&&ee&&Ha(ze),Ii.setScale&&Ut&&ee){let Se=ft,ye=Nt,de=yt,qt=Dt;if(L.ori==1&&(Se=yt,ye=Dt,de=ft,qt=Nt),Ei&&Es(T,Hn(Se,T),Hn(Se+ye,T)),Ti)for(let Wt in M){let Ve=M[Wt];Wt!=T&&Ve.from==null&&Ve.min!=De&&Es(Wt,Hn(de+qt,Wt),Hn(de,Wt))}su()}else ut.lock&&(ut._lock=!ut._lock,Ys(b,!0,x!=null));x!=null&&(gi(du,_u),Fo(du,i,Be,Xe,U,Ct,null))}function B_(x,b,P,I,z,K,at){if(ut._lock)return;Zt(x);let ft=ws;if(ws){let yt=!0,Nt=!0,Dt=10,Ut,ee;L.ori==0?(Ut=Ei,ee=Ti):(Ut=Ti,ee=Ei),Ut&&ee&&(yt=Be<=Dt||Be>=U-Dt,Nt=Xe<=Dt||Xe>=Ct-Dt),Ut&&yt&&(Be=Be<Rr?0:U),ee&&Nt&&(Xe=Xe<Cr?0:Ct),Ys(null,!0,!0),ws=!1}Be=-10,Xe=-10,st.fill(null),Ys(null,!0,!0),ft&&(ws=ft)}function Hf(x,b,P,I,z,K,at){ut._lock||(Zt(x),Io(),su(),x!=null&&Fo(cp,i,Be,Xe,U,Ct,null))}function Gf(){A.forEach(dy),F(i.width,i.height,!0)}er(il,zr,Gf);let Lr={};Lr.mousedown=zf,Lr.mousemove=Ff,Lr.mouseup=Vf,Lr.dblclick=Hf,Lr.setSeries=(x,b,P,I)=>{let z=ui.match[2];P=z(i,b,P),P!=-1&&Vn(P,I,!0,!1)},mt&&(ve(op,g,zf),ve(uu,g,Ff),ve(ap,g,x=>{Zt(x),Do(!1)}),ve(lp,g,B_),ve(cp,g,Hf),Eu.add(i),i.syncRect=Do);let Ga=i.hooks=n.hooks||{};function Ai(x,b,P){Bi?Re.push([x,b,P]):x in Ga&&Ga[x].forEach(I=>{I.call(null,i,b,P)})}(n.plugins||[]).forEach(x=>{for(let b in x.hooks)Ga[b]=(Ga[b]||[]).concat(x.hooks[b])});let Wf=(x,b,P)=>P,ui=di({key:null,setSeries:!1,filters:{pub:yp,sub:yp},scales:[T,y[1]?y[1].scale:null],match:[Mp,Mp,Wf],values:[null,null]},ut.sync);ui.match.length==2&&ui.match.push(Wf),ut.sync=ui;let Xf=ui.key,ru=_m(Xf);function Fo(x,b,P,I,z,K,at){ui.filters.pub(x,b,P,I,z,K,at)&&ru.pub(x,b,P,I,z,K,at)}ru.sub(i);function z_(x,b,P,I,z,K,at){ui.filters.sub(x,b,P,I,z,K,at)&&Lr[x](null,b,P,I,z,K,at)}i.pub=z_;function V_(){ru.unsub(i),Eu.delete(i),wi.clear(),yu(il,zr,Gf),c.remove(),At?.remove(),Ai("destroy")}i.destroy=V_;function ou(){Ai("init",n,t),Po(t||n.data,!1),V[T]?jh(T,V[T]):Io(),nt=ze.show&&(ze.width>0||ze.height>0),et=pt=!0,F(n.width,n.height)}return y.forEach(Sr),A.forEach(is),e?e instanceof HTMLElement?(e.appendChild(c),ou()):e(i,ou):ou(),i}Ni.assign=di;Ni.fmtNum=Lu;Ni.rangeNum=nl;Ni.rangeLog=ol;Ni.rangeAsinh=Pu;Ni.orient=nr;Ni.pxRatio=be;Ni.join=nv;Ni.fmtDate=Du,Ni.tzDate=pv;Ni.sync=_m;{Ni.addGap=Kv,Ni.clipGaps=cl;let n=Ni.paths={points:bm};n.linear=Em,n.stepped=Qv,n.bars=ty,n.spline=iy}var fy=3,Cm=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim(),Yr=class{constructor(t,e,i,s=!1){this.host=t,this.series=i;let r=i.filter(({low:h,high:f})=>h&&f);this.names=[...i.map(({name:h})=>h),...r.flatMap(({low:h,high:f})=>[h??"",f??""])],this.own=s&&i.length>1;let o=h=>this.own?`y${h}`:"y",a=(h,f)=>({scale:o(f),stroke:`${h}80`,width:1,class:"bound",points:{show:!1},gaps:Im});this.extremes=[];let l=(this.own?i:[null]).map((h,f)=>[o(f),{range:()=>py(...this.extremes[f]??[null,null])}]),c=()=>Cm("--faint"),d={stroke:()=>Cm("--line"),width:1},u="11px system-ui, sans-serif";this.uplot=new Ni({width:100,height:100,pxAlign:!1,cursor:{drag:{x:!1,y:!1},points:{size:6},sync:{key:"ropewalk"}},legend:{live:!0},scales:{x:{time:!1,auto:!1,range:(h,f,g)=>[f,g]},...Object.fromEntries(l)},axes:[{stroke:c,grid:d,ticks:{...d,size:4},font:u,size:24,values:(h,f)=>f.map(g=>`${Ie(g)} s`)},...(this.own?i.slice(0,2):[null]).map((h,f)=>({scale:o(f),side:f===0?3:1,stroke:h?h.colour:c,grid:f===0?d:{show:!1},ticks:{...d,size:4},font:u,size:52,space:20,values:(g,_)=>_.map(m=>Ne(m,e))}))],series:[{label:"time",value:(h,f)=>f===null?"":`${f.toFixed(2)} s`},...i.map(({label:h,colour:f},g)=>({label:h,scale:o(g),stroke:f,width:1.6,points:{show:!1},gaps:Im,value:(_,m)=>m===null?"":Ne(m,e)})),...r.flatMap(h=>{let f=i.indexOf(h);return[a(h.colour,f),a(h.colour,f)]})],bands:r.map(({colour:h},f)=>({series:[i.length+2*f+2,i.length+2*f+1],fill:`${h}40`}))},[[],...this.names.map(()=>[])],t),this.resize()}resize(){let t=this.host.querySelector(".u-legend"),e=t instanceof HTMLElement?t.offsetHeight:24,i=this.host.clientWidth,s=Math.max(60,this.host.clientHeight-e-2);i>40&&(this.uplot.width!==i||this.uplot.height!==s)&&this.uplot.setSize({width:i,height:s})}show(t,e,i){this.extremes=this.own?this.series.map((s,r)=>Pm(this.columnsOf(r,t))):[Pm(t)],this.uplot.batch(()=>{this.uplot.setData(t,!1),this.uplot.setScale("x",{min:e,max:i})})}columnsOf(t,e){let{name:i,low:s,high:r}=this.series[t],o=new Set([i,s,r]);return e.filter((a,l)=>l===0||o.has(this.names[l-1]))}destroy(){this.uplot.destroy()}};function Pm([,...n]){let[t,e]=[1/0,-1/0];for(let i of n)for(let s of i)Number.isFinite(s)&&(s<t&&(t=s),s>e&&(e=s));return t<=e?[t,e]:[null,null]}function py(n,t){if(n===null||t===null||!Number.isFinite(n)||!Number.isFinite(t))return[0,1];let e=Math.max(.08*(t-n),.01*Math.max(Math.abs(n),Math.abs(t)),1e-9);return[n-e,t+e]}function Im(n,t,e,i){let[s,r]=[n.data[0],n.data[t]],o=a=>n.valToPos(s[a],"x",!0);return my(s,r,e,i).map(([a,l])=>[o(a),o(l)])}function my(n,t,e,i){let s=[],r=-1;for(let o=e;o<=i;o++)Number.isFinite(t[o])&&(r>=0&&(o>r+1||n[o]-n[r]>fy)&&s.push([r,o]),r=o);return s}function fl(n,t,e){let i=t.parts[0],s=n.scalars.map((u,h)=>[u,i.scalars[h]]),[r,o,a]=n.up,{seen:l}=i,c=u=>Dr(n,i,u,"tension_low","tension_high"),d=u=>Dr(n,i,u,"low","high");for(let u of e){let[h,f,g]=i.positions.subarray(3*u,3*u+3),_=h*r+f*o+g*a,m=gy(n,u);s.push([`height ${u}`,_],[`low height ${u}`,Math.min(_,d(l.leastHeight[u]))],[`high height ${u}`,Math.max(_,d(l.greatestHeight[u]))],[`speed ${u}`,Dr(n,i,l.greatestSpeed[u],null,"speed_high")],[`tension ${u}`,c(l.greatestTension[m])],[`low tension ${u}`,c(l.leastTension[m])])}return l.greatestForce.forEach((u,h)=>s.push([`force ${h}`,u])),n.variants.slice(1).forEach((u,h)=>{s.push([`difference ${h+1}`,en(n,t.parts[h+1],"difference")])}),s}function gy(n,t){for(let{first:e,nodes:i}of n.variants[0].ropes)if(t>=e&&t<e+i)return Math.max(e,Math.min(t,e+i-2));return t}var Vu=[2,5,10,30,60,1/0],_y=.1,xy=66,Lm={energies:"Energies",tension:"Tension",forces:"Forces",motion:"Height or speed",phase:"Phase plane",difference:"Difference"},vy=[["kinetic","kinetic",qe[0]],["gravity","gravity, from the start",qe[2]],["elastic","elastic",qe[1]],["lost","lost",qe[3]]],yy={tension:n=>({low:`low tension ${n}`,high:`tension ${n}`}),height:n=>({low:`low height ${n}`,high:`high height ${n}`}),speed:()=>({})},pl=class{constructor(t,e){this.stage=t,this.host=e,this.history=new Ka,this.window=10,this.back=0,this.wanted=()=>{},this.quantity="height",this.panels=new Map,this.lastDraw=0,this.soon=!1,this.turn=0,this.plots=H("div",{className:"plots"}),this.chips=H("div",{className:"chips"}),this.scroll=H("input",{type:"range",id:"graph-scroll",min:"0",max:"0",step:"any","aria-label":"Scroll back in time",oninput:()=>{this.back=Number(this.scroll.max)-Number(this.scroll.value),this.drawAll()}}),this.windowChoice=H("select",{id:"graph-window","aria-label":"Seconds shown",onchange:()=>this.setWindow(Number(this.windowChoice.value.replace("all","Infinity")))},...Vu.map(s=>H("option",{value:Number.isFinite(s)?String(s):"all",selected:s===this.window},Number.isFinite(s)?`${s} s`:"all"))),this.quantityChoice=H("select",{id:"graph-quantity","aria-label":"Height or speed",onchange:()=>this.setQuantity()},H("option",{value:"height"},"Height"),H("option",{value:"speed"},"Speed")),this.own=!1,this.ownScales=H("button",{type:"button",className:"chip",id:"own-scales","aria-pressed":"false",title:"Each line fills the height: its shape is seen, whatever its size",onclick:()=>this.setOwn(!this.own)},"Own scales"),e.append(H("div",{className:"graph-bar"},this.chips,this.quantityChoice,this.ownScales,H("label",{},"Last",this.windowChoice),this.scroll),this.plots);let i=matchMedia("(max-width: 700px)").matches;this.shown=new Set(i?["energies"]:["energies","tension","motion"]),t.session.on("frame",s=>this.take(s)),t.session.on("layout",()=>this.rebuild()),t.session.on("status",()=>this.bounds()),new ResizeObserver(()=>this.resize()).observe(this.plots),this.plots.addEventListener("wheel",s=>this.wheel(s),{passive:!1})}get open(){return!this.host.hidden}toggle(t=!this.open){this.host.hidden=!t,t?this.rebuild():this.clear()}take(t){let{layout:e}=this.stage.session;if(!e)return;if(t.flags&2&&this.stage.session.hello?.mode==="replay"){this.drawSoon();return}if(this.history.add(t.time,fl(e,t,this.stage.marks.followed)),!this.open)return;if(!(t.flags&1)){this.drawSoon();return}let i=performance.now();if(i-this.lastDraw<xy/Math.max(1,this.panels.size))return;this.lastDraw=i;let s=[...this.panels.values()];this.turn=(this.turn+1)%Math.max(1,s.length),s[this.turn]&&this.draw(s[this.turn]),this.turn===0&&this.bounds()}clear(){for(let{plot:t,box:e}of this.panels.values())t instanceof Yr&&t.destroy(),e.remove();this.panels.clear()}rebuild(){if(!this.open)return;this.clear();let t=(this.stage.session.layout?.variants.length??1)>1,e=(this.stage.session.layout?.variants[0].anchors.length??0)>0,i=Object.keys(Lm).filter(s=>(s!=="difference"||t)&&(s!=="forces"||e));this.chips.replaceChildren(...i.map(s=>this.chip(s))),this.quantityChoice.hidden=!this.shown.has("motion");for(let s of i){if(!this.shown.has(s))continue;let r=H("div",{className:"plot",data:{kind:s}});this.plots.append(r),this.panels.set(s,{kind:s,box:r,plot:null})}for(let s of this.panels.values())s.plot=this.make(s);requestAnimationFrame(()=>this.resize()),this.bounds(),this.wanted()}get span(){return Number.isFinite(this.window)?this.window:Math.max(Vu[0],this.history.last-this.history.first)||Vu[0]}chip(t){return H("button",{type:"button",className:"chip","aria-pressed":String(this.shown.has(t)),data:{graph:t},onclick:()=>{matchMedia("(max-width: 700px)").matches&&this.shown.clear(),this.shown.delete(t)||this.shown.add(t),this.rebuild()}},Lm[t])}make({kind:t,box:e}){if(t==="phase")return new Ja(e);let i={energies:"J",tension:"N",forces:"N",motion:this.quantity==="height"?"m":"m/s",difference:"m"}[t];return new Yr(e,i,this.series(t),this.own)}series(t){if(t==="energies")return vy.map(([r,o,a])=>({name:r,label:o,colour:a}));let e=this.stage.session.layout?.variants??[];if(t==="difference")return e.slice(1).map((r,o)=>({name:`difference ${o+1}`,label:`${r.label}, rms`,colour:qe[(o+1)%qe.length]}));if(t==="forces")return(e[0]?.anchors??[]).slice(0,qe.length).map(({name:r},o)=>({name:`force ${o}`,label:r,colour:qe[o]}));let i=t==="tension"?"tension":this.quantity,s=[...this.stage.marks.followed].map((r,o)=>({name:`${i} ${r}`,label:this.nodeName(r),colour:qe[(o+1)%qe.length],...yy[i](r)}));return t==="tension"?[{name:"tension_max",label:"largest",colour:qe[0]},...s]:this.quantity==="speed"?[{name:"speed_high",label:"fastest",colour:qe[0]},...s]:s.length?s:[{name:"high",label:"highest",colour:qe[0]},{name:"low",label:"lowest",colour:qe[5]}]}nodeName(t){let e=this.stage.session.layout?.variants[0].ropes??[],i=e.find(({first:s,nodes:r})=>t>=s&&t<s+r);return e.length>1&&i?`${i.name} ${t-i.zero}`:`node ${t-(i?.zero??0)}`}draw({kind:t,plot:e}){if(!Number.isFinite(this.history.last))return;let i=this.history.last-this.back,s=Math.min(Math.max(i-this.span,this.history.first),i-_y);if(e instanceof Yr)e.show(this.history.between(s,i,e.names),s,i);else if(e&&t==="phase"){let r=[...this.stage.marks.followed][0],[o,a]=this.history.between(s,i,[`height ${r}`]);e.show(o,a,qe[1])}}drawSoon(){this.soon||(this.soon=!0,requestAnimationFrame(()=>{this.soon=!1,this.bounds(),this.drawAll()}))}drawAll(){for(let t of this.panels.values())this.draw(t)}bounds(){let t=this.stage.session.status?.playing??!0,e=Math.max(0,this.history.last-this.history.first-this.span)||0;t&&(this.back=0),this.scroll.disabled=t||e===0,this.scroll.title=t?"Pause to scroll back":"Scroll back in time",this.scroll.max=String(e),this.scroll.value=String(e-this.back),t||this.drawAll()}wheel(t){if(this.scroll.disabled)return;t.preventDefault();let e=(t.deltaX||t.deltaY)/400*this.span;this.back=Math.min(Number(this.scroll.max),Math.max(0,this.back-e)),this.bounds()}setWindow(t){this.window=t,this.back=0,this.wanted(),this.bounds(),this.drawAll()}setOwn(t){this.own=t,this.ownScales.setAttribute("aria-pressed",String(t)),this.rebuild()}setQuantity(){this.quantity=this.quantityChoice.value,this.rebuild()}resize(){for(let{plot:t}of this.panels.values())t?.resize();this.drawAll()}};var ml=class{constructor(t,e){this.name=H("span",{className:"scene-name"},"…"),this.choose=H("button",{type:"button",className:"scene-choice",id:"open-scenes",title:"Scenes",onclick:e.scenes},this.name,mn("down")),this.tour=xi("tour","Guided tour",e.tour,{words:"Tour",id:"open-tour"}),this.compare=xi("compare","Compare copies",e.compare,{words:"Compare",id:"open-compare"}),this.keep=xi("keep","Save, export, link",()=>e.keep(this.keep),{words:"Keep",id:"open-keep"}),this.panel=xi("panel","Panel of constants",e.panel,{key:"P",id:"toggle-panel"}),t.append(H("strong",{className:"brand"},"Ropewalk"),this.choose,H("span",{className:"gap"}),this.tour,this.compare,this.keep,xi("help","Help",e.help,{key:"H",id:"open-help"}),xi("theme","Light or dark",e.theme,{key:"T",id:"toggle-theme"}),this.panel)}show(t){this.name.textContent=t,this.choose.setAttribute("aria-label",`Scene: ${t}. Choose another`),document.title=`${t} – Ropewalk`}};function Nm(n){return n?n.bound===null?"The rope was moved farther in one step than the computation can follow. Try a shorter step.":n.stable?"The step is short enough for a rope at its length, so something pulled or threw a piece of it too far: a hand, a fast anchor, a heavy load. Be gentler, or take a shorter step.":"Each step was too long for so stiff and light a rope: within one step a piece of it flew past where its neighbours pull it back to, then farther past on the other side, and so on. A real rope would not do this; the computation did. A shorter step, softer springs or more mass keep it together.":"The rope has flown apart. Why is being looked at."}function Dm(n){if(!n||n.meter===null||n.meter_limit===null)return"";let{meter:t,meter_limit:e,meter_name:i}=n;return`The meter: ${i} = ${Ie(t)}, at most ${Ie(e)}.`}var My=300,Sy=3,by={back:"Back to before",step:"Use the suggested step",implicit:"Use an implicit method",on:"Go on with these values"},gl=class{constructor(t,e,i){this.session=t,this.draw=i,this.timer=0,this.card=H("section",{className:"card broken",hidden:!0,role:"alert",id:"broken"}),e.append(this.card),t.on("broken",s=>this.show(s)),t.on("frame",({flags:s})=>this.tellReplay((s&2)!==0))}tellReplay(t){let{hello:e,layout:i}=this.session;e?.mode!=="replay"||this.card.hidden!==t||(this.card.hidden=!t,!(!t||!i?.broke)&&this.card.replaceChildren(H("h2",{},"The run broke"),H("p",{},i.broke.text||`It broke after t = ${Ie(i.broke.time)} s.`),H("p",{className:"faint"},"Shown: steps past the last good frame. No number counts them.")))}show(t){if(this.card.hidden=t===null,clearTimeout(this.timer),!t)return;let e=t.remedies.map((i,s)=>H("button",{type:"button",className:s===0?"main":"second",data:{remedy:i.id},onclick:()=>this.session.tell({type:"remedy",remedy:i.id})},i.label||by[i.id]));this.card.replaceChildren(H("h2",{},"The simulation broke"),H("p",{className:"why"},Nm(t.cause)),H("details",{},H("summary",{},"The theory, in numbers"),H("p",{},`${t.text} ${Dm(t.cause)}`)),H("div",{className:"row"},...e,...this.look(t)))}look(t){let{past:e}=t;if(!e?.length)return[];let i=H("span",{className:"faint",id:"past"}),s=o=>{let a=e[Math.min(o,e.length-1)],l=o===e.length+Sy;this.draw(l?null:a.positions,t.variant),i.textContent=l?"":`${a.time.toFixed(5)} s: past the last good state`,l||(this.timer=window.setTimeout(()=>s(o+1),My))};return[H("button",{type:"button",className:"second",id:"see-break",onclick:()=>{clearTimeout(this.timer),s(0)}},"See it break"),i]}};function _l(n){let t=[],e=0;for(let i of n.variants)t.push(e),e+=i.nodes;return t}var Zi=n=>n.variants.reduce((t,e)=>t+e.nodes,0);function Zr(n,t,e){let i=n.variants.length>1?t:n.variants[t].ropes[e].color;return Js(qe[i%qe.length])}function Fm(n){let t=_l(n),e=[];return n.variants.forEach((i,s)=>{i.ropes.forEach((r,o)=>{e.push({name:r.name,first:t[s]+r.first,count:r.nodes,radius:r.diameter/2,spacing:r.length/Math.max(1,r.segments),colour:Zr(n,s,o),loose:wy(i,r)})})}),{nodes:Zi(n),ropes:e}}function wy({anchors:n,loads:t},{first:e,nodes:i}){let s=new Set([...n,...t].map(({index:r})=>r));return[!s.has(e),!s.has(e+i-1)]}function Um(n){let t=_l(n),e=new Uint8Array(Zi(n));return n.variants.forEach(({anchors:i,loads:s},r)=>{for(let{index:o}of[...i,...s])e[t[r]+o]=1}),e}function Om(n,t,e,i){return n.variants.map((s,r)=>Ze(e,t?r*i:0))}function km(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?e*(i/e)**t:e+t*(i-e);return n.whole?Math.round(r):Number(r.toPrecision(3))}function Bm(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?Math.log(Math.max(t,e)/e)/Math.log(i/e):(t-e)/(i-e);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Ps(n){let t=n.trim().replace(",",".").replace("−","-");return t===""?NaN:Number(t)}function Kr(n,t=11){let e=String(Number(n.toPrecision(6)));return e.length<=t?e:Number(n.toPrecision(t-5)).toExponential()}var Ey=["bdf2","rk4"],Ty=3,xl=class{constructor(t,e,i,s){this.stage=t,this.colours=s,this.changes=[],this.rows=H("div",{className:"compare-rows"}),this.fault=H("p",{className:"fault",hidden:!0,role:"alert"}),this.add=H("button",{type:"button",className:"second",onclick:()=>this.addRow()},"One more copy"),this.apart=H("select",{id:"compare-way","aria-label":"How copies are shown",onchange:()=>this.stage.setApart(this.apart.value==="apart")},H("option",{value:"over"},"overlaid"),H("option",{value:"apart"},"side by side")),this.stop=H("button",{type:"button",className:"second",id:"compare-end",onclick:()=>this.end()},"End the comparison"),this.window=Or("Compare","compare",H("p",{},"Copies of this scene run beside it with one constant changed, moved by the same hand."),this.rows,this.fault,H("div",{className:"row"},this.add,H("span",{className:"gap"}),this.stop,H("button",{type:"button",className:"main",id:"compare-start",onclick:()=>this.start()},"Compare"))),e.append(this.window),this.lines=H("div",{}),this.card=H("div",{className:"card difference",hidden:!0,id:"difference"},H("div",{className:"row"},H("strong",{},"Copies"),this.apart,H("button",{type:"button",className:"second small",onclick:()=>this.end()},"End")),this.lines),i.append(this.card),t.card=()=>this.place(),this.lastShown=0,this.wasMany=!1,this.fresh=!1,t.session.on("layout",()=>this.layout()),t.session.on("frame",()=>this.show())}open(){this.changes.length||(this.changes=this.suggested()),this.fill(),this.stop.hidden=!this.wasMany,this.window.showModal()}suggested(){let{parameters:t,status:e,stability:i}=this.stage.session,s=t.find(c=>c.name==="method"),r=i[0]?.steps??{},o=(s?.choices??[]).map(({value:c})=>c),a=c=>(r[c]??1/0)>(e?.dt??0),l=Ey.find(c=>c!==s?.value&&o.includes(c));return l&&a(l)?[{name:"method",value:l}]:e?[{name:"time_step",value:e.dt/2}]:[]}get choices(){return this.stage.session.parameters.filter(t=>t.kind!=="vector"&&t.enabled)}addRow(){let{status:t}=this.stage.session;this.changes.push({name:"time_step",value:t?t.dt/2:.001}),this.fill()}fill(){this.add.disabled=this.changes.length>=Ty,this.rows.replaceChildren(...this.changes.map((t,e)=>this.row(t,e)))}row(t,e){let i=this.choices.find(o=>o.name===t.name)??this.choices[0],s=H("select",{"aria-label":`What copy ${e+1} changes`,onchange:()=>{let o=this.choices.find(a=>a.name===s.value);this.changes[e]={name:s.value,value:o?.value},this.fill()}},...this.choices.map(o=>H("option",{value:o.name,selected:o===i},o.label))),r=H("button",{type:"button",className:"second small","aria-label":`Remove copy ${e+1}`,onclick:()=>{this.changes.splice(e,1),this.fill()}},"Remove");return H("div",{className:"row"},s,this.valueField(i,t),r)}valueField(t,e){if(t.kind==="choice"||t.kind==="flag"){let s=t.choices??[!0,!1].map(o=>({value:o,label:o?"yes":"no"})),r=H("select",{"aria-label":t.label,onchange:()=>e.value=s[r.selectedIndex].value},...s.map(({value:o,label:a})=>H("option",{selected:o===e.value},a)));return r.selectedIndex>=0&&(e.value=s[r.selectedIndex].value),r}let i=H("input",{type:"text",inputMode:"decimal","aria-label":t.label,value:typeof e.value=="number"?Kr(e.value):"",oninput:()=>e.value=Ps(i.value)});return H("label",{},i,Fr(t.unit))}label({name:t,value:e}){let i=this.stage.session.parameters.find(s=>s.name===t);return i?.kind==="choice"||typeof e!="number"?String(e):`${i?.label??t} ${Ne(e,i?.unit)}`}async start(){let t=this.changes.map(e=>({label:this.label(e),changes:{[e.name]:e.value}}));try{await this.stage.session.ask({type:"compare",variants:t}),this.fault.hidden=!0,this.window.close()}catch(e){this.fault.textContent=e.text,this.fault.hidden=!1}}async end(){this.window.close(),await this.stage.session.tell({type:"compare",variants:[]})}layout(){let t=this.stage.session.layout,e=t.variants.length>1;this.card.hidden=!e,e!==this.wasMany&&this.colours(e),e&&!this.wasMany&&(this.fresh=!0),this.wasMany=e,this.lines.replaceChildren(...t.variants.map((i,s)=>{let r=H("i",{});return r.style.background=Ke(Zr(t,s,0)),H("div",{className:"line"},r,H("span",{},i.label),H("output",{}))}))}place(){if(!this.card.getClientRects().length)return null;let{x:t,y:e,width:i,height:s}=this.card.getBoundingClientRect(),r=this.stage.renderer.canvas.getBoundingClientRect();return new DOMRect(t-r.x,e-r.y,i,s)}show(){let{layout:t,frame:e}=this.stage.session,i=performance.now();!t||!e||this.card.hidden||i-this.lastShown<200&&!this.fresh||(this.lastShown=i,e.parts.forEach((s,r)=>{let o=this.lines.children[r]?.querySelector("output");if(!o||r===0)return;let a=Ne(en(t,s,"difference"),"m"),l=Ne(en(t,s,"difference_max"),"m");o.textContent=`differs by ${a} rms, ${l} at most`}),this.fresh&&this.stage.uncover(),this.fresh=!1)}};var vl=class{constructor(t){this.rate=t,this.force=NaN,this.quick=0,this.phase=0}restart(){[this.force,this.quick,this.phase]=[NaN,0,0]}add(t,e,i){if(!Number.isFinite(t))return;let s=this.quick,r=Math.exp(-2*Math.PI*20*e);Number.isFinite(this.force)&&(this.quick=r*(s+t-this.force)),this.force=t;let o=e*this.rate,a=1-this.phase;for(;a<=o;)i.push(s+(this.quick-s)*(a/o)),a+=1;this.phase=1-(a-o)}},yl=class{constructor(){this.context=null,this.resampler=new vl(1),this.samples=[],this.loudest=0,this.next=0}get on(){return this.context!==null}turn(t){t&&!this.context?(this.context=new AudioContext,this.resampler=new vl(this.context.sampleRate),this.next=0):!t&&this.context&&(this.context.close(),this.context=null)}restart(){this.resampler.restart(),this.samples=[],this.loudest=0}hear(t,e){this.resampler.add(t,e,this.samples)}play(){let{context:t,samples:e}=this;if(!t||e.length===0)return;this.samples=[];for(let a of e)this.loudest=Math.max(this.loudest,Math.abs(a));let i=Math.max(this.next,t.currentTime+.06);if(i>t.currentTime+.25)return;let s=t.createBuffer(1,e.length,t.sampleRate),r=this.loudest>0?.25/this.loudest:0;s.copyToChannel(Float32Array.from(e,a=>r*a),0);let o=t.createBufferSource();o.buffer=s,o.connect(t.destination),o.start(i),this.next=i+e.length/t.sampleRate}};var Ml=class{constructor(t){this.session=t,this.sound=new yl,this.heard=0,this.button=xi("sound","Sound of the first anchor's force",()=>this.turn(),{id:"sound"}),this.show(),t.on("sound",({seconds:e,forces:i})=>this.hear(e,i)),t.on("hello",()=>{this.show(),this.sound.on&&t.send({type:"listen",on:!0})}),t.on("status",({playing:e})=>e||this.sound.restart())}turn(){this.sound.turn(!this.sound.on),this.sound.restart(),this.session.send({type:"listen",on:this.sound.on}),this.show()}show(){this.button.hidden=!this.session.can("listen"),this.button.setAttribute("aria-pressed",String(this.sound.on))}hear(t,e){if(this.sound.on){this.heard+=e.length;for(let i of e)this.sound.hear(i,t);this.sound.play()}}};var Ay=100,Hu=[.01,.02,.05,.1,.2,.5,1,2,4],zm=n=>n>=.995?`${Ie(n)}×`:`1/${Ie(1/n)}×`,Sl=class{constructor(t,e,i){this.session=t,this.reset=xi("reset","Reset to time zero",()=>this.doReset(),{key:"R",id:"reset"}),this.undo=xi("undo","Undo",()=>this.doUndo(),{id:"undo"}),this.play=xi("play","Play",()=>this.toggle(),{key:"space",id:"play",kind:"main"}),this.step=xi("step","One step",()=>this.doStep(),{key:"full stop",id:"step"}),this.clock=H("output",{id:"clock",title:"Simulated time"},"0.00 s"),this.speed=H("input",{type:"range",id:"speed",min:"0",max:String(Hu.length-1),step:"1","aria-label":"Speed",oninput:()=>this.setSpeed()}),this.speedText=H("output",{id:"speed-text"},"1×"),this.reached=H("output",{id:"realtime",className:"faint"},""),this.seek=H("input",{type:"range",id:"seek",min:"0",max:"1",step:"any","aria-label":"Time in the recording",oninput:()=>this.doSeek()}),this.graphs=xi("graph","Graphs",i,{words:"Graphs",key:"G",id:"toggle-graphs"}),this.hearing=new Ml(t),this.seeking=0,this.shown=-1/0,e.append(H("div",{className:"group"},this.reset,this.undo,this.play,this.step),this.clock,this.seek,H("label",{className:"speed",title:"Speed, as a part of real time"},"Speed",this.speed,this.speedText),this.reached,H("span",{className:"gap"}),this.hearing.button,this.graphs),t.on("hello",()=>this.refresh()),t.on("status",()=>this.refresh()),t.on("frame",s=>this.showTime(s.time)),this.refresh()}refresh(){let{session:t}=this,{status:e}=t;this.play.hidden=!t.can("play"),this.step.hidden=!t.can("step"),this.reset.hidden=!t.can("reset"),this.undo.hidden=!t.can("undo");let i=this.speed.parentElement;if(i.hidden=!t.can("speed"),this.seek.hidden=!t.can("seek")||!e?.duration,!e)return;!e.playing&&t.frame&&this.showTime(t.frame.time);let s=e.undo?`Undo ${e.undo}`:"Nothing to undo";this.undo.disabled=!e.undo,this.undo.title=`${s} (Ctrl+Z)`,this.undo.setAttribute("aria-label",s),this.play.disabled=e.broken,this.step.disabled=e.broken||e.playing;let r=e.playing?"pause":"play";if(this.play.dataset.shows!==r){this.play.dataset.shows=r,this.play.replaceChildren(mn(r,r==="play"));let o=e.playing?"Pause":"Play";this.play.title=`${o} (space)`,this.play.setAttribute("aria-label",o)}document.activeElement!==this.speed&&(this.speed.value=String(Ry(e.speed))),this.speedText.textContent=zm(e.speed),this.reached.textContent=e.playing?`reached ${Ie(e.realtime)}×`:"paused",this.reached.classList.toggle("slow",e.slow),this.reached.title=e.text||"Simulated time per real time, over the last half second",e.duration&&(this.seek.max=String(e.duration))}showTime(t){let e=performance.now();if(e-this.shown>=Ay||!this.session.status?.playing){this.shown=e;let i=`${t.toFixed(2)} s`;this.clock.textContent!==i&&(this.clock.textContent=i)}!this.seek.hidden&&document.activeElement!==this.seek&&(this.seek.value=String(t))}toggle(){let{status:t}=this.session;!t||t.broken||!this.session.can("play")||this.session.tell({type:t.playing?"pause":"play"})}async doStep(){let{status:t}=this.session;!t||t.broken||!this.session.can("step")||(t.playing?await this.session.tell({type:"pause"}):await this.session.tell({type:"step"}))}doReset(){this.session.can("reset")&&this.session.tell({type:"reset"})}doUndo(){this.session.status?.undo&&this.session.can("undo")&&this.session.tell({type:"undo"})}setSpeed(){let t=Hu[Number(this.speed.value)];this.speedText.textContent=zm(t),this.session.tell({type:"speed",value:t})}doSeek(){cancelAnimationFrame(this.seeking),this.seeking=requestAnimationFrame(()=>{this.session.send({type:"seek",time:Number(this.seek.value)})})}};function Ry(n){let t=Hu.map(e=>Math.abs(Math.log(e/n)));return t.indexOf(Math.min(...t))}var Cy=[["Drag an anchor (a ring)","it follows the hand, in the plane of a flat scene, else parallel to the screen"],["Drag the rope","by a soft spring; its force is shown in newtons, and below the tools one may limit it"],["Let go in motion","throws it: it has the hand's velocity"],["Hold Shift at the end of a drag","the spring stays; double-click on empty space lets go"],["Right-click, or a long press","pin, cut, load, kick, follow"],["Drag empty space","turn the view; with Shift, the right button or near a rope: shift it"],["Wheel, or two fingers","zoom"]],Py=[["← → ↑ ↓","move the first anchor at 3 m/s"],["Home, End","move it away from you, towards you"],["A D W S Q E","the same for the second anchor"],["J L I K U O","the same for the third anchor"],["Tab, Enter","on the scene: the next place on the ropes, its menu"],["Space","play or pause"],[".","one step"],["R","reset to time zero"],["Ctrl Z","undo the last cut, pin, load, kick or reset"],["F","show everything"],["G","graphs"],["P","panel of constants"],["T","light or dark"],["H or ?","this help"]],bl=class{constructor(t){let e=(i,s)=>H("dl",{},...i.flatMap(([r,o])=>[H("dt",{},H(s,{},r)),H("dd",{},o)]));this.version=H("p",{className:"faint"}),this.window=Or("Help","help",H("div",{className:"columns"},H("section",{},H("h3",{},"Hand"),e(Cy,"span")),H("section",{},H("h3",{},"Keys"),e(Py,"kbd"))),this.version),t.append(this.window)}open(){this.window.open?this.window.close():this.window.showModal()}};var Iy={"nodes.csv":"Table of nodes (CSV)","energies.csv":"Table of energies (CSV)","tension.csv":"Table of tension (CSV)","scene.toml":"Scene (TOML)","page.html":"Page that replays it (HTML)"},wl=class{constructor(t,e,i){this.stage=t,this.host=e,this.notices=i}open(t){let{session:e}=this.stage,{base:i}=e.source,{hello:s}=e,r=[{label:"Save the run",id:"keep-save",hint:s?.folder??"",show:e.can("save"),press:()=>this.save()},{label:"Copy the link to this set-up",id:"keep-link",show:e.can("scene"),press:()=>this.copyLink()},{label:"Copy the command line",id:"keep-command",show:e.can("scene")&&Vm(e.status?.address)!=="",press:()=>this.copyCommand()},{label:"Picture (PNG)",id:"keep-png",show:!0,press:()=>this.picture()},...(s?.exports??[]).map(l=>({label:Iy[l]??l,id:`keep-${l.replace(".","-")}`,show:!0,press:()=>this.file(`${i}export/${l}`,l)}))],o=t.getBoundingClientRect(),a=this.host.getBoundingClientRect();zo(this.host,o.right-a.left-240,o.bottom-a.top+4,r.filter(({show:l})=>l),"Keep")}async save(){await this.stage.session.tell({type:"save"})}async file(t,e){this.notices.say(`Making ${e} …`);try{let i=await fetch(t);if(!i.ok)throw new Error(i.status===404?"it cannot be made here":await i.text());let s=URL.createObjectURL(await i.blob());cu(s,e),setTimeout(()=>URL.revokeObjectURL(s),1e4),this.notices.say(`${e} is in your downloads.`)}catch(i){this.notices.say(`${e}: ${i instanceof Error?i.message:i}`,"fault")}}picture(){this.stage.draw(!0),this.stage.renderer.canvas.toBlob(t=>{if(!t)return;let e=URL.createObjectURL(t);cu(e,`${Ly(this.stage.session.layout?.scene.name??"rope")}.png`),setTimeout(()=>URL.revokeObjectURL(e),1e4)})}async copyLink(){let t=this.stage.session.status,e=`${location.href.split("#")[0]}${t?.address?`#${t.address}`:""}`;await this.copy(e,"The link is copied. It opens this scene with these constants, as long as this view runs.")}async copyCommand(){let t=Vm(this.stage.session.status?.address);await this.copy(t,"The command is copied. In a terminal it opens this set-up again.")}async copy(t,e){try{await navigator.clipboard.writeText(t),this.notices.say(e)}catch{this.notices.say(t)}}};function Vm(n){let t=new URLSearchParams(n??""),e=t.get("toml")||!["","start"].includes(t.get("scene")??"");return!n||!e?"":`ropewalk view --at "${n}"`}var Ly=n=>n.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"rope";function Hm([n,t],[e,i],[s,r],o){let a=Math.hypot(e,i),[l,c]=a>1?[e/a,i/a]:[1,0],d=5+Math.min(s/2/Math.abs(l||1e-9),r/2/Math.abs(c||1e-9)),u=[n+l*d,t+c*d],h=s/2+15,f=r/2+15,g=[u,[u[0],u[1]-r],[u[0],u[1]+r],[n,t-f],[n,t+f],[n+h,t],[n-h,t],[n,t-f-1.5*r],[n,t+f+1.5*r]],_=(m,p)=>Math.max(2,Math.min(m,p-2));return g.map(([m,p])=>({x:_(m-s/2,o[0]-s),y:_(p-r/2,o[1]-r),width:s,height:r}))}function Gu(n,t,e){return!t.some(i=>Ny(n,i))&&!e.some(([i,s])=>i>n.x&&i<n.x+n.width&&s>n.y&&s<n.y+n.height)}function Ny(n,t){return n.x<t.x+t.width&&t.x<n.x+n.width&&n.y<t.y+t.height&&t.y<n.y+n.height}var Dy=7.4,Fy=22,Uy=18,Oy=2.5,ky=600,By=10,zy=90,Vy=".toolbar, .legend, .difference, .tour, .broken, .slow-note, .banner",Hy=100,Gy=1e3,El=class{constructor(t,e){this.stage=t,this.host=e,this.box=H("div",{className:"labels","aria-hidden":"true"}),this.pool=[],this.taken=[],this.since=[],this.cards=[],this.watched=new Set,this.looked=this.worded=-1/0,this.watch=new ResizeObserver(()=>{this.looked=-1/0,t.marks.dirty=!0}),this.watch.observe(e),e.append(this.box),t.afterDraw.push(()=>this.refresh())}refresh(){let{labels:t}=this.stage.marks;for(;this.pool.length<t.length;){let a=H("span",{});this.pool.push(a),this.box.append(a)}let e=t.flatMap(({from:a,at:l})=>[this.plate(a,By),this.plate(l,Oy)]),i=t.length?[...this.cardsNow(),...e]:[],s=t.length?this.beads():[],r=performance.now(),o=r-this.worded>=Hy||!this.stage.session.status?.playing;o&&(this.worded=r),this.pool.forEach((a,l)=>{let c=t[l],u=o||a.hidden||a.className!==c?.kind?c?.text:a.textContent,h=c?this.place({...c,text:u??""},l,i,s):null;a.hidden===(h!==null)&&(a.hidden=!a.hidden),h&&(i.push(h),a.textContent!==u&&(a.textContent=u??""),a.className!==c.kind&&(a.className=c.kind),a.style.transform=`translate(${Math.round(h.x)}px, ${Math.round(h.y)}px)`)}),o&&this.stage.marks.written()}place({from:t,at:e,text:i},s,r,o){let{camera:a}=this.stage,[l,c,d]=a.project(...e);if(!(d>0))return null;let[u,h]=a.project(...t),f=[Dy*i.length+Uy,Fy],g=[a.width,a.height],_=Hm([l,c],[l-u,c-h],f,g),m=this.taken[s]??0,p=performance.now(),y=p-(this.since[s]??-1/0)<ky?[m,..._.keys()]:[..._.keys()],M=y.find(R=>Gu(_[R],r,o))??y.find(R=>Gu(_[R],r,[]));return M===void 0?null:(M!==m&&(this.since[s]=p),this.taken[s]=M,_[M])}plate(t,e){let[i,s]=this.stage.camera.project(...t);return{x:i-e,y:s-e,width:2*e,height:2*e}}beads(){let{camera:t,nodes:e,session:i}=this.stage,s=i.layout?Zi(i.layout):0,r=Math.max(1,Math.ceil(s/zy)),o=[];for(let a=0;a<s;a+=r){let[l,c,d]=e.shown.subarray(4*a,4*a+3);o.push(t.project(l,c,d))}return o}cardsNow(){let t=performance.now();if(t-this.looked<Gy)return this.cards;this.looked=t;let{left:e,top:i}=this.host.getBoundingClientRect();return this.cards=[...this.host.querySelectorAll(Vy)].map(s=>{this.watched.has(s)||this.watch.observe(s),this.watched.add(s);let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();return{x:r-e,y:o-i,width:a,height:l}}),this.cards}};var Wy=100,Xy=2e-9;function $y(n,t){return n==="strain"||n==="utilisation"?["%",100]:n==="speed"?["m/s",1]:t>=1e7?["MN",1e-6]:t>=1e4?["kN",.001]:["N",1]}function qy(n){if(!(n>0))return"Most: 0 %";let t=`Most: ${Ie(Number((100*n).toPrecision(3)))} %`;return n>1?`${t}: it would have parted`:`${t}, safety factor ${Ie(Number((1/n).toPrecision(3)))}`}var Tl=class{constructor(t,e){this.stage=t,this.written=-1/0,this.select=H("select",{id:"colouring","aria-label":"Colour of the ropes",onchange:()=>this.choose()},H("option",{value:"tension"},"Tension"),H("option",{value:"strain"},"Tension / EA"),this.near=H("option",{value:"utilisation",hidden:!0},"Tension / breaking load"),H("option",{value:"speed"},"Speed"),H("option",{value:"plain"},"Plain colours")),this.bar=H("div",{className:"map"}),this.dark=null,this.low=H("span",{}),this.middle=H("span",{}),this.high=H("span",{}),this.numbers=H("div",{className:"numbers",id:"legend-numbers"},this.low,this.middle,this.high),this.ropes=H("div",{className:"rope-names"}),this.arrows=this.check("Forces","show-forces",!0,i=>t.marks.reactions=i),this.dots=this.check("Nodes","show-nodes",!1,i=>t.dots=i),this.posts=this.check("Posts","show-posts",!0,i=>t.marks.standing=i),this.posts.className="posts",this.margin=H("div",{className:"numbers",id:"margin",hidden:!0}),this.given=H("div",{className:"numbers",id:"given",hidden:!0}),this.grid=H("span",{}),this.thick=H("span",{}),e.append(H("div",{className:"card legend"},this.select,this.bar,this.numbers,this.margin,this.ropes,H("div",{className:"row"},this.arrows,this.dots,this.posts),H("div",{className:"numbers drawn-as"},this.grid,this.thick),this.given)),t.session.on("layout",()=>this.names()),t.session.on("status",()=>this.refresh()),t.afterDraw.push(()=>{(!t.session.status?.playing||performance.now()-this.written>=Wy)&&this.refresh()})}check(t,e,i,s){let r=H("input",{type:"checkbox",id:e,checked:i,onchange:()=>{s(r.checked),this.stage.dirty=!0}});return H("label",{},r,t)}choose(){this.stage.setColouring(this.select.value),this.names()}names(){this.written=-1/0;let{layout:t}=this.stage.session,e=this.stage.colouring==="plain";if(this.bar.hidden=this.numbers.hidden=e,this.ropes.replaceChildren(),t){this.tellGiven(t);let r=t.variants.some(({ropes:o})=>o.some(a=>a.breaking_load));if(this.near.hidden=this.near.disabled=!r,!r&&this.stage.colouring==="utilisation")return this.select.value="tension",this.choose()}if(this.margin.hidden=this.stage.colouring!=="utilisation",!t||!e)return;let s=t.variants.length>1?t.variants.map((r,o)=>({name:r.label,colour:Zr(t,o,0)})):t.variants[0].ropes.map((r,o)=>({name:r.name,colour:Zr(t,0,o)}));for(let{name:r,colour:o}of s.slice(0,6)){let a=H("i",{});a.style.background=Ke(o),this.ropes.append(H("span",{},a,r))}s.length>6&&this.ropes.append(H("span",{className:"faint"},`and ${s.length-6} more`))}tellGiven({variants:[{ropes:t,forces:e}]}){let s=t.filter(({submerged_weight:o})=>typeof o=="number").slice(0,2).map(({name:o,submerged_weight:a})=>`${t.length>1?`${o} `:""}weighs ${Ne(a,"N/m")} in water`);e.length&&s.push("arrows at nodes: constant forces");let r=s.join("; ");this.given.hidden=!r,Is(this.given,r&&r[0].toUpperCase()+r.slice(1))}paint(){let{dark:t}=this.stage.theme;if(t===this.dark)return;this.dark=t;let e=Ur(t),i=Array.from({length:17},(s,r)=>Ke(e[Math.round(r/16*(e.length-1))]));this.bar.style.backgroundImage=`linear-gradient(to right, ${i.join(", ")})`}refresh(){this.paint(),this.written=performance.now(),this.margin.hidden||Is(this.margin,qy(this.stage.most));let{range:t,colouring:e}=this.stage,{low:i,high:s}=t,[r,o]=$y(e,Math.max(Math.abs(i),Math.abs(s))),a=c=>Ie(Number((c*o).toPrecision(2))),l=s-i>Xy;if(this.low.hidden=this.middle.hidden=!l,!l)return Is(this.high,`${a(i)} ${r}`),this.showGrid();Is(this.low,a(i)),Is(this.middle,a((i+s)/2)),Is(this.high,`${a(s)} ${r}`),this.showGrid()}showGrid(){Is(this.grid,`Grid ${Ne(this.stage.spacing,"m")}`);let t=this.stage.thickness();Is(this.thick,t>1.05?`Drawn ${Ie(Number(t.toPrecision(2)))}× thick`:"True thickness")}};function Is(n,t){n.textContent!==t&&(n.textContent=t)}var Zo=1.25,Al=class{constructor(t,e){this.session=t,this.host=e,t.on("stability",i=>this.show(i)),t.on("layout",()=>this.show(t.stability))}show(t){let e=t.length>1;this.host.hidden=t.length===0,this.host.classList.toggle("many",e),this.host.replaceChildren(...t.map((i,s)=>this.row(i,s,e)))}row(t,e,i){let{ratio:s,zone:r}=t,o=this.session.layout?.variants[e]?.label,a=H("div",{className:"fill"});a.style.width=`${100*Math.min(1,(s??0)/Zo)}%`;let l=H("div",{className:"tick"});l.style.left=`${100/Zo}%`;let c=H("div",{className:"amber-zone"});c.style.left=`${90/Zo}%`,c.style.width=`${10/Zo}%`;let d=H("div",{className:"red-zone"});d.style.left=`${100/Zo}%`;let u=H("div",{className:"meter-bar",role:"meter","aria-label":"Step as a part of the largest stable step","aria-valuemin":"0","aria-valuemax":"1.25","aria-valuenow":String(s??0)},a,c,d,l),h=[];return t.bound!==null&&h.push([`largest step ${Ne(t.bound,"s")}`,"step"]),t.largest_spring_constant!==null?h.push([`largest spring constant ${Ne(t.largest_spring_constant,"N/m")}`,"k"]):t.largest_axial_stiffness!==null&&h.push([`largest EA ${Ne(t.largest_axial_stiffness,"N")}`,"k"]),H("div",{className:`meter-row ${r}`,title:t.verdict,data:{zone:r}},H("span",{className:"meter-name"},i&&o?o:"Stability"),u,H("strong",{className:"meter-ratio"},s===null||t.bound===null?"no bound":Yy(s)),...h.map(([f,g])=>H("span",{className:`meter-fact ${g}`},f)))}};function Yy(n){return n>=10?`${Ie(n)} times the bound`:`${Ie(100*n)} % of the bound`}var Zy=7e3,Ky=3,Rl=class{constructor(t,e){this.list=H("div",{className:"notices","aria-live":"polite"}),this.banner=H("div",{className:"banner",hidden:!0,role:"alert",id:"banner"}),this.slow=H("div",{className:"slow-note",hidden:!0,id:"slow"}),e.append(this.banner,this.slow,this.list),t.on("error",i=>this.say(i.text,"fault")),t.on("note",({text:i})=>this.say(i)),t.on("saved",({folder:i})=>this.say(`Saved in ${i}`)),t.on("connection",({state:i,text:s})=>this.connection(i,s)),t.on("status",({slow:i,text:s,broken:r})=>{let o=i&&s!==""&&!r;this.slow.hidden=!o,o&&this.slow.textContent!==s&&(this.slow.textContent=s)})}connection(t,e){if(this.banner.hidden=t==="open",this.banner.classList.toggle("calm",t==="waiting"),document.documentElement.dataset.connection=t,t!=="open")if(t==="damaged")this.banner.replaceChildren(e);else{let i=t==="waiting"?"":" Trying again …";this.banner.replaceChildren(H("span",{className:"spinner"}),`${e}${i}`)}}say(t,e="note"){for(let r of this.list.children)r.firstChild?.textContent===t&&r.remove();let i=H("button",{type:"button",className:"plain","aria-label":"Close",onclick:()=>s.remove()},mn("close")),s=H("div",{className:`notice ${e}`},H("span",{},t),i);for(this.list.append(s);this.list.children.length>Ky;)this.list.firstChild?.remove();setTimeout(()=>s.remove(),Zy)}};var Cl=class{constructor(t,e){this.session=t,this.list=H("div",{className:"scene-themes"}),this.window=Or("Scenes","scenes",this.list),e.append(this.window),t.on("presets",()=>this.fill()),t.on("layout",()=>this.mark())}open(){this.mark(),this.window.showModal()}fill(){let{presets:t}=this.session,e=[...new Set(t.map(({theme:i})=>i))];this.list.replaceChildren(...e.flatMap(i=>[H("h3",{},i),H("div",{className:"scene-list"},...t.filter(s=>s.theme===i).map(s=>this.card(s)))])),this.mark()}card(t){let{base:e}=this.session.source,i=H("div",{className:"picture"});return t.picture&&e&&(i.style.maskImage=`url("${new URL(e+t.picture,location.href.split(/[?#]/)[0]).href}")`),H("button",{type:"button",className:"scene-card",data:{preset:t.name},onclick:()=>this.choose(t.name)},i,H("strong",{},t.title),H("span",{},t.sentence))}mark(){let t=this.session.layout?.scene.preset;for(let e of this.list.querySelectorAll(".scene-card"))e instanceof HTMLElement&&e.classList.toggle("now",e.dataset.preset===t)}async choose(t){this.window.close(),await this.session.tell({type:"scene",preset:t})&&this.session.send({type:"play"})}};var Gm=[["hand","hand","Hand: drag anchors and ropes",""],["pin","pin","Pin: hold a node where it is, or let it go again","pin"],["cut","cut","Cut a segment","cut"],["load","load","Hang a load on a node","load"],["kick","kick","Kick: draw the velocity from a node","kick"],["follow","follow","Follow a node: its trail and its graphs",""]],Pl=class{constructor(t,e,i){this.stage=t,this.host=e,this.follow=i,this.pointer=null,this.mass=1,this.buttons=new Map,this.bar=H("div",{className:"toolbar",role:"toolbar","aria-label":"Tools"});for(let[s,r,o]of Gm){let a=xi(r,o,()=>this.choose(s),{id:`tool-${s}`});this.buttons.set(s,a),this.bar.append(a)}this.massField=H("input",{type:"text",inputMode:"decimal",value:"1",id:"load-mass","aria-label":"Mass to hang [kg]",onchange:()=>{let s=Ps(this.massField.value);s>=0&&(this.mass=s),this.massField.value=String(this.mass),this.massField.blur()}}),this.massBox=H("label",{className:"mass",hidden:!0},this.massField,"kg"),this.pullField=H("input",{type:"text",inputMode:"decimal",value:"",placeholder:"auto",id:"pull-limit",title:"Pull with at most this force; empty: 20 times the rope's weight","aria-label":"Largest force of a pull [N]; empty: 20 times the rope's weight",onchange:()=>this.limitPull()}),this.pullBox=H("label",{className:"mass pull",hidden:!0},this.pullField,"N"),this.bar.append(this.massBox,this.pullBox),e.append(this.bar),t.session.on("hello",()=>this.refresh()),this.refresh()}refresh(){for(let[t,,,e]of Gm){let i=this.buttons.get(t);i&&(i.hidden=e!==""&&!this.stage.session.can(e))}this.choose(this.pointer?.tool??"hand")}choose(t){this.pointer&&(this.pointer.tool=t);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t));this.massBox.hidden=t!=="load",this.pullBox.hidden=t!=="hand"||!this.stage.session.can("grab"),this.host.dataset.tool=t}limitPull(){let t=Ps(this.pullField.value),e=t>0?t:null;this.pointer&&(this.pointer.limit=e),this.pullField.value=e===null?"":String(e),this.pullField.blur()}use(t,e){let{session:i}=this.stage;t==="pin"?e.kind==="anchor"?i.tell({type:"unpin",anchor:e.anchor}):i.tell({type:"pin",node:e.node}):t==="cut"?i.tell({type:"cut",segment:e.segment}):t==="load"?i.tell({type:"load",node:e.node,mass:this.mass}):t==="follow"&&this.follow(e.node)}menu(t,e,i){let{session:s,marks:r}=this.stage;if(!t){zo(this.host,e,i,[{label:"Show everything",press:()=>this.stage.fit()},{label:"Let go of everything",press:()=>s.send({type:"let_go"}),disabled:!s.can("let_go")}]);return}let{node:o}=t,l=(s.layout?.variants[0].loads.filter(f=>f.index===o)??[]).reduce((f,g)=>f+g.mass,0),c=this.stage.camera.up,u=[t.kind==="anchor"?{label:"Let this node go",command:"unpin",press:()=>s.tell({type:"unpin",anchor:t.anchor})}:{label:"Pin it here",command:"pin",press:()=>s.tell({type:"pin",node:o})},{label:"Cut here",command:"cut",press:()=>s.tell({type:"cut",segment:t.segment})},...[1,10].map(f=>({label:`Hang ${f} kg here`,command:"load",press:()=>s.tell({type:"load",node:o,mass:f})})),...l>0?[{label:`Take the load off (${Ie(l)} kg)`,command:"load",press:()=>s.tell({type:"load",node:o,mass:0})}]:[],{label:"Kick it up (5 m/s)",command:"kick",press:()=>s.tell({type:"kick",node:o,velocity:Ze(c,5)})}].filter(f=>s.can(f.command)),h=r.followed.has(o);zo(this.host,e,i,[...u,{label:h?"Stop following":"Follow: trail and graphs",press:()=>this.follow(o)}],t.kind==="anchor"?`Anchor ${t.anchor}`:this.nodeName(t))}nodeName(t){let e=this.stage.session.layout?.variants[t.variant].ropes??[],i=e.find(({first:s,nodes:r})=>t.node>=s&&t.node<s+r);return i?`Node ${t.node-i.zero}${e.length>1?` of ${i.name}`:""}`:`Node ${t.node}`}};var Jy=["r4","hanging-rope"],jy=2,Wm="bdf2",Ko=[{title:"Hang it",text:"A rope is a chain of masses and springs. Let it hang and swing: its colour is the tension in newtons.",act:"Hang the rope",press:n=>n.hang(),done:({session:n,hung:t})=>t&&(n.frame?.time??0)>1},{title:"Move it",text:"Take an anchor, one of the squares, and move it. The arrow keys do it too, at 3 m/s. Then pull at the rope itself.",act:"",press:()=>{},done:({moved:n})=>n},{title:"Stiffen it until it breaks",text:"Make the springs stiffer and watch the meter: beyond the red line every step overshoots, nodes jump to and fro, and the rope breaks.",act:"Twice as stiff",press:n=>n.stiffen(),done:({session:n})=>n.broken!==null},{title:"Make the step smaller",text:"Nothing is wrong with the rope: the time step is too long for springs so stiff. A shorter step mends it, and costs more computing.",act:"Use a shorter step",press:n=>n.shorten(),done:({session:n})=>n.broken===null&&n.stability[0]?.stable===!0},{title:"Take an implicit method",text:"An implicit method solves for the next state and bears any stiffness with long steps. The meter has no red any more.",act:"Use an implicit method",press:n=>n.implicit(),done:({session:n})=>n.stability[0]?.bound===null}],Il=class{constructor(t,e){this.session=t,this.at=-1,this.hung=this.moved=!1,this.card=H("section",{className:"card tour",hidden:!0,"aria-label":"Guided tour",id:"tour"}),e.append(this.card),t.on("status",()=>this.check()),t.on("stability",()=>this.check()),t.on("broken",()=>this.check())}start(){if(this.at>=0){this.end();return}this.hung=this.moved=!1,this.go(0)}end(){this.at=-1,this.card.hidden=!0}handMoved(){this.moved||(this.moved=!0,this.check())}go(t){if(this.at=t,t>=Ko.length){this.end();return}let{title:e,text:i,act:s,press:r}=Ko[t],o=t===Ko.length-1;t===1&&(this.moved=!1);let a=t!==4||this.implicitMethod()!==null,l=H("button",{type:"button",className:"plain close","aria-label":"End the tour",onclick:()=>this.end()},mn("close"));this.card.replaceChildren(H("header",{},H("small",{},`Step ${t+1} of ${Ko.length}`),l),H("h2",{},e),H("p",{},i),a?"":H("p",{className:"faint"},"This version has no implicit method yet; a Runge-Kutta method bears a longer step."),H("div",{className:"row"},s!==""?H("button",{type:"button",className:"main",id:"tour-act",disabled:!a,onclick:()=>r(this)},s):"",H("span",{className:"gap"}),t>0?H("button",{type:"button",className:"second",onclick:()=>this.go(t-1)},"Back"):"",H("button",{type:"button",className:"second",id:"tour-next",onclick:()=>this.go(t+1)},o?"Finish":"Next"))),this.card.hidden=!1,this.check()}check(){if(this.at<0)return;let t=Ko[this.at].done(this);this.card.classList.toggle("done",t);let e=this.card.querySelector("#tour-next");e&&(e.className=t?"main":"second")}async hang(){let{session:t}=this,e=Jy.find(i=>t.presets.some(s=>s.name===i))??t.presets[0]?.name;e&&t.can("scene")&&await t.tell({type:"scene",preset:e}),this.hung=!0,await t.tell({type:"play"})}async stiffen(){let{session:t}=this,e=t.parameters.find(i=>i.name==="spring_constant")??t.parameters.find(i=>i.name==="EA");!e||typeof e.value!="number"||(await t.tell({type:"set",name:e.name,value:e.value*jy}),t.status?.playing||await t.tell({type:"play"}))}async shorten(){let{session:t}=this;t.broken?await t.tell({type:"remedy",remedy:"step"}):await t.tell({type:"set",name:"time_step",value:"auto"}),await t.tell({type:"play"})}implicitMethod(){let e=this.session.parameters.find(s=>s.name==="method")?.choices??[];if(e.some(({value:s})=>s===Wm))return Wm;let i=e.find(({value:s,label:r})=>/implicit|sdirk|bdf|midpoint/i.test(`${s} ${r}`)&&!/semi-implicit/i.test(`${s}`));return i?i.value:null}async implicit(){let t=this.implicitMethod();t!==null&&(this.session.broken?await this.session.tell({type:"remedy",remedy:"implicit"}):await this.session.tell({type:"set",name:"method",value:t}),await this.session.tell({type:"play"}))}};var $n=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},Wu=class extends $n{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function Xu(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var Qy={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:Xu,toHexString:Xu},jo={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},tM={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=jo.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return jo.toHexString(s)}},eM={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=jo.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return jo.toHexString(s)}},iM=[Qy,jo,tM,eM];function nM(n){return iM.find(t=>t.match(n))}var $u=class extends $n{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=nM(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=Xu(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Jo=class extends $n{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},qu=class extends $n{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let y=parseFloat(this.$input.value);isNaN(y)||(this._stepExplicit&&(y=this._snap(y)),this.setValue(this._clamp(y)))},i=y=>{let A=parseFloat(this.$input.value);isNaN(A)||(this._snapClampSetValue(A+y),this.$input.value=this.getValue())},s=y=>{y.key==="Enter"&&this.$input.blur(),y.code==="ArrowUp"&&(y.preventDefault(),i(this._step*this._arrowKeyMultiplier(y))),y.code==="ArrowDown"&&(y.preventDefault(),i(this._step*this._arrowKeyMultiplier(y)*-1))},r=y=>{this._inputFocused&&(y.preventDefault(),i(this._step*this._normalizeMouseWheel(y)))},o=!1,a,l,c,d,u,h=5,f=y=>{a=y.clientX,l=c=y.clientY,o=!0,d=this.getValue(),u=0,window.addEventListener("mousemove",g),window.addEventListener("mouseup",_)},g=y=>{if(o){let A=y.clientX-a,M=y.clientY-l;Math.abs(M)>h?(y.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(A)>h&&_()}if(!o){let A=y.clientY-c;u-=A*this._step*this._arrowKeyMultiplier(y),d+u>this._max?u=this._max-d:d+u<this._min&&(u=this._min-d),this._snapClampSetValue(d+u)}c=y.clientY},_=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",g),window.removeEventListener("mouseup",_)},m=()=>{this._inputFocused=!0},p=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",m),this.$input.addEventListener("blur",p)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(p,y,A,M,R)=>(p-y)/(A-y)*(R-M)+M,e=p=>{let y=this.$slider.getBoundingClientRect(),A=t(p,y.left,y.right,this._min,this._max);this._snapClampSetValue(A)},i=p=>{this._setDraggingStyle(!0),e(p.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=p=>{e(p.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=p=>{p.preventDefault(),this._setDraggingStyle(!0),e(p.touches[0].clientX),o=!1},d=p=>{p.touches.length>1||(this._hasScrollBar?(a=p.touches[0].clientX,l=p.touches[0].clientY,o=!0):c(p),window.addEventListener("touchmove",u,{passive:!1}),window.addEventListener("touchend",h))},u=p=>{if(o){let y=p.touches[0].clientX-a,A=p.touches[0].clientY-l;Math.abs(y)>Math.abs(A)?c(p):(window.removeEventListener("touchmove",u),window.removeEventListener("touchend",h))}else p.preventDefault(),e(p.touches[0].clientX)},h=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",u),window.removeEventListener("touchend",h)},f=this._callOnFinishChange.bind(this),g=400,_,m=p=>{if(Math.abs(p.deltaX)<Math.abs(p.deltaY)&&this._hasScrollBar)return;p.preventDefault();let A=this._normalizeMouseWheel(p)*this._step;this._snapClampSetValue(this.getValue()+A),this.$input.value=this.getValue(),clearTimeout(_),_=setTimeout(f,g)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",d,{passive:!1}),this.$slider.addEventListener("wheel",m,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},Yu=class extends $n{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},Zu=class extends $n{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},sM=`.lil-gui {
  font-family: var(--font-family);
  font-size: var(--font-size);
  line-height: 1;
  font-weight: normal;
  font-style: normal;
  text-align: left;
  color: var(--text-color);
  user-select: none;
  -webkit-user-select: none;
  touch-action: manipulation;
  --background-color: #1f1f1f;
  --text-color: #ebebeb;
  --title-background-color: #111111;
  --title-text-color: #ebebeb;
  --widget-color: #424242;
  --hover-color: #4f4f4f;
  --focus-color: #595959;
  --number-color: #2cc9ff;
  --string-color: #a2db3c;
  --font-size: 11px;
  --input-font-size: 11px;
  --font-family: -apple-system, BlinkMacSystemFont, "Segoe UI", Roboto, Arial, sans-serif;
  --font-family-mono: Menlo, Monaco, Consolas, "Droid Sans Mono", monospace;
  --padding: 4px;
  --spacing: 4px;
  --widget-height: 20px;
  --title-height: calc(var(--widget-height) + var(--spacing) * 1.25);
  --name-width: 45%;
  --slider-knob-width: 2px;
  --slider-input-width: 27%;
  --color-input-width: 27%;
  --slider-input-min-width: 45px;
  --color-input-min-width: 45px;
  --folder-indent: 7px;
  --widget-padding: 0 0 0 3px;
  --widget-border-radius: 2px;
  --checkbox-size: calc(0.75 * var(--widget-height));
  --scrollbar-width: 5px;
}
.lil-gui, .lil-gui * {
  box-sizing: border-box;
  margin: 0;
  padding: 0;
}
.lil-gui.lil-root {
  width: var(--width, 245px);
  display: flex;
  flex-direction: column;
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-title {
  background: var(--title-background-color);
  color: var(--title-text-color);
}
.lil-gui.lil-root > .lil-children {
  overflow-x: hidden;
  overflow-y: auto;
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar {
  width: var(--scrollbar-width);
  height: var(--scrollbar-width);
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar-thumb {
  border-radius: var(--scrollbar-width);
  background: var(--focus-color);
}
@media (pointer: coarse) {
  .lil-gui.lil-allow-touch-styles, .lil-gui.lil-allow-touch-styles .lil-gui {
    --widget-height: 28px;
    --padding: 6px;
    --spacing: 6px;
    --font-size: 13px;
    --input-font-size: 16px;
    --folder-indent: 10px;
    --scrollbar-width: 7px;
    --slider-input-min-width: 50px;
    --color-input-min-width: 65px;
  }
}
.lil-gui.lil-force-touch-styles, .lil-gui.lil-force-touch-styles .lil-gui {
  --widget-height: 28px;
  --padding: 6px;
  --spacing: 6px;
  --font-size: 13px;
  --input-font-size: 16px;
  --folder-indent: 10px;
  --scrollbar-width: 7px;
  --slider-input-min-width: 50px;
  --color-input-min-width: 65px;
}
.lil-gui.lil-auto-place, .lil-gui.autoPlace {
  max-height: 100%;
  position: fixed;
  top: 0;
  right: 15px;
  z-index: 1001;
}

.lil-controller {
  display: flex;
  align-items: center;
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
}
.lil-controller.lil-disabled {
  opacity: 0.5;
}
.lil-controller.lil-disabled, .lil-controller.lil-disabled * {
  pointer-events: none !important;
}
.lil-controller > .lil-name {
  min-width: var(--name-width);
  flex-shrink: 0;
  white-space: pre;
  padding-right: var(--spacing);
  line-height: var(--widget-height);
}
.lil-controller .lil-widget {
  position: relative;
  display: flex;
  align-items: center;
  width: 100%;
  min-height: var(--widget-height);
}
.lil-controller.lil-string input {
  color: var(--string-color);
}
.lil-controller.lil-boolean {
  cursor: pointer;
}
.lil-controller.lil-color .lil-display {
  width: 100%;
  height: var(--widget-height);
  border-radius: var(--widget-border-radius);
  position: relative;
}
@media (hover: hover) {
  .lil-controller.lil-color .lil-display:hover:before {
    content: " ";
    display: block;
    position: absolute;
    border-radius: var(--widget-border-radius);
    border: 1px solid #fff9;
    top: 0;
    right: 0;
    bottom: 0;
    left: 0;
  }
}
.lil-controller.lil-color input[type=color] {
  opacity: 0;
  width: 100%;
  height: 100%;
  cursor: pointer;
}
.lil-controller.lil-color input[type=text] {
  margin-left: var(--spacing);
  font-family: var(--font-family-mono);
  min-width: var(--color-input-min-width);
  width: var(--color-input-width);
  flex-shrink: 0;
}
.lil-controller.lil-option select {
  opacity: 0;
  position: absolute;
  width: 100%;
  max-width: 100%;
}
.lil-controller.lil-option .lil-display {
  position: relative;
  pointer-events: none;
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  line-height: var(--widget-height);
  max-width: 100%;
  overflow: hidden;
  word-break: break-all;
  padding-left: 0.55em;
  padding-right: 1.75em;
  background: var(--widget-color);
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-display.lil-focus {
    background: var(--focus-color);
  }
}
.lil-controller.lil-option .lil-display.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-option .lil-display:after {
  font-family: "lil-gui";
  content: "↕";
  position: absolute;
  top: 0;
  right: 0;
  bottom: 0;
  padding-right: 0.375em;
}
.lil-controller.lil-option .lil-widget,
.lil-controller.lil-option select {
  cursor: pointer;
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-widget:hover .lil-display {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number input {
  color: var(--number-color);
}
.lil-controller.lil-number.lil-has-slider input {
  margin-left: var(--spacing);
  width: var(--slider-input-width);
  min-width: var(--slider-input-min-width);
  flex-shrink: 0;
}
.lil-controller.lil-number .lil-slider {
  width: 100%;
  height: var(--widget-height);
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
  padding-right: var(--slider-knob-width);
  overflow: hidden;
  cursor: ew-resize;
  touch-action: pan-y;
}
@media (hover: hover) {
  .lil-controller.lil-number .lil-slider:hover {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number .lil-slider.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-number .lil-slider.lil-active .lil-fill {
  opacity: 0.95;
}
.lil-controller.lil-number .lil-fill {
  height: 100%;
  border-right: var(--slider-knob-width) solid var(--number-color);
  box-sizing: content-box;
}

.lil-dragging .lil-gui {
  --hover-color: var(--widget-color);
}
.lil-dragging * {
  cursor: ew-resize !important;
}
.lil-dragging.lil-vertical * {
  cursor: ns-resize !important;
}

.lil-gui .lil-title {
  height: var(--title-height);
  font-weight: 600;
  padding: 0 var(--padding);
  width: 100%;
  text-align: left;
  background: none;
  text-decoration-skip: objects;
}
.lil-gui .lil-title:before {
  font-family: "lil-gui";
  content: "▾";
  padding-right: 2px;
  display: inline-block;
}
.lil-gui .lil-title:active {
  background: var(--title-background-color);
  opacity: 0.75;
}
@media (hover: hover) {
  body:not(.lil-dragging) .lil-gui .lil-title:hover {
    background: var(--title-background-color);
    opacity: 0.85;
  }
  .lil-gui .lil-title:focus {
    text-decoration: underline var(--focus-color);
  }
}
.lil-gui.lil-root > .lil-title:focus {
  text-decoration: none !important;
}
.lil-gui.lil-closed > .lil-title:before {
  content: "▸";
}
.lil-gui.lil-closed > .lil-children {
  transform: translateY(-7px);
  opacity: 0;
}
.lil-gui.lil-closed:not(.lil-transition) > .lil-children {
  display: none;
}
.lil-gui.lil-transition > .lil-children {
  transition-duration: 300ms;
  transition-property: height, opacity, transform;
  transition-timing-function: cubic-bezier(0.2, 0.6, 0.35, 1);
  overflow: hidden;
  pointer-events: none;
}
.lil-gui .lil-children:empty:before {
  content: "Empty";
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
  display: block;
  height: var(--widget-height);
  font-style: italic;
  line-height: var(--widget-height);
  opacity: 0.5;
}
.lil-gui.lil-root > .lil-children > .lil-gui > .lil-title {
  border: 0 solid var(--widget-color);
  border-width: 1px 0;
  transition: border-color 300ms;
}
.lil-gui.lil-root > .lil-children > .lil-gui.lil-closed > .lil-title {
  border-bottom-color: transparent;
}
.lil-gui + .lil-controller {
  border-top: 1px solid var(--widget-color);
  margin-top: 0;
  padding-top: var(--spacing);
}
.lil-gui .lil-gui .lil-gui > .lil-title {
  border: none;
}
.lil-gui .lil-gui .lil-gui > .lil-children {
  border: none;
  margin-left: var(--folder-indent);
  border-left: 2px solid var(--widget-color);
}
.lil-gui .lil-gui .lil-controller {
  border: none;
}

.lil-gui label, .lil-gui input, .lil-gui button {
  -webkit-tap-highlight-color: transparent;
}
.lil-gui input {
  border: 0;
  outline: none;
  font-family: var(--font-family);
  font-size: var(--input-font-size);
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  background: var(--widget-color);
  color: var(--text-color);
  width: 100%;
}
@media (hover: hover) {
  .lil-gui input:hover {
    background: var(--hover-color);
  }
  .lil-gui input:active {
    background: var(--focus-color);
  }
}
.lil-gui input:disabled {
  opacity: 1;
}
.lil-gui input[type=text],
.lil-gui input[type=number] {
  padding: var(--widget-padding);
  -moz-appearance: textfield;
}
.lil-gui input[type=text]:focus,
.lil-gui input[type=number]:focus {
  background: var(--focus-color);
}
.lil-gui input[type=checkbox] {
  appearance: none;
  width: var(--checkbox-size);
  height: var(--checkbox-size);
  border-radius: var(--widget-border-radius);
  text-align: center;
  cursor: pointer;
}
.lil-gui input[type=checkbox]:checked:before {
  font-family: "lil-gui";
  content: "✓";
  font-size: var(--checkbox-size);
  line-height: var(--checkbox-size);
}
@media (hover: hover) {
  .lil-gui input[type=checkbox]:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui button {
  outline: none;
  cursor: pointer;
  font-family: var(--font-family);
  font-size: var(--font-size);
  color: var(--text-color);
  width: 100%;
  border: none;
}
.lil-gui .lil-controller button {
  height: var(--widget-height);
  text-transform: none;
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
}
@media (hover: hover) {
  .lil-gui .lil-controller button:hover {
    background: var(--hover-color);
  }
  .lil-gui .lil-controller button:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui .lil-controller button:active {
  background: var(--focus-color);
}

@font-face {
  font-family: "lil-gui";
  src: url("data:application/font-woff2;charset=utf-8;base64,d09GMgABAAAAAALkAAsAAAAABtQAAAKVAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAHFQGYACDMgqBBIEbATYCJAMUCwwABCAFhAoHgQQbHAbIDiUFEYVARAAAYQTVWNmz9MxhEgodq49wYRUFKE8GWNiUBxI2LBRaVnc51U83Gmhs0Q7JXWMiz5eteLwrKwuxHO8VFxUX9UpZBs6pa5ABRwHA+t3UxUnH20EvVknRerzQgX6xC/GH6ZUvTcAjAv122dF28OTqCXrPuyaDER30YBA1xnkVutDDo4oCi71Ca7rrV9xS8dZHbPHefsuwIyCpmT7j+MnjAH5X3984UZoFFuJ0yiZ4XEJFxjagEBeqs+e1iyK8Xf/nOuwF+vVK0ur765+vf7txotUi0m3N0m/84RGSrBCNrh8Ee5GjODjF4gnWP+dJrH/Lk9k4oT6d+gr6g/wssA2j64JJGP6cmx554vUZnpZfn6ZfX2bMwPPrlANsB86/DiHjhl0OP+c87+gaJo/gY084s3HoYL/ZkWHTRfBXvvoHnnkHvngKun4KBE/ede7tvq3/vQOxDXB1/fdNz6XbPdcr0Vhpojj9dG+owuSKFsslCi1tgEjirjXdwMiov2EioadxmqTHUCIwo8NgQaeIasAi0fTYSPTbSmwbMOFduyh9wvBrESGY0MtgRjtgQR8Q1bRPohn2UoCRZf9wyYANMXFeJTysqAe0I4mrherOekFdKMrYvJjLvOIUM9SuwYB5DVZUwwVjJJOaUnZCmcEkIZZrKqNvRGRMvmFZsmhP4VMKCSXBhSqUBxgMS7h0cZvEd71AWkEhGWaeMFcNnpqyJkyXgYL7PQ1MoSq0wDAkRtJIijkZSmqYTiSImfLiSWXIZwhRh3Rug2X0kk1Dgj+Iu43u5p98ghopcpSo0Uyc8SnjlYX59WUeaMoDqmVD2TOWD9a4pCRAzf2ECgwGcrHjPOWY9bNxq/OL3I/QjwEAAAA=") format("woff2");
}`;function rM(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var Xm=!1,Ll=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!Xm&&a&&(rM(sM),Xm=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new Yu(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new qu(this,t,e,i,s,r);case"boolean":return new Wu(this,t,e);case"string":return new Zu(this,t,e);case"function":return new Jo(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new $u(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Jo||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Jo)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var Ku=1e3,oM=9,$m=$n,Nl=class extends $m{constructor(t,e,i){super(t,e,"value","quantity"),this.parameter=i,this.sliding=!1,this.slider=H("input",{type:"range",min:"0",max:String(Ku),step:"1","aria-label":i.label,oninput:()=>{this.sliding=!0,this.setValue(km(this.scale,Number(this.slider.value)/Ku))},onchange:()=>{this.sliding=!1,this._callOnFinishChange()}}),this.field=H("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} [${i.unit}]`,onchange:()=>this.commit(),onkeydown:s=>{s.key==="Enter"&&this.commit()}}),this.$widget.append(this.slider,this.field),this.updateDisplay()}get scale(){let{low:t,high:e,scale:i,kind:s}=this.parameter;return{low:t,high:e,scale:i,whole:s==="whole"}}commit(){let t=this.getValue(),i=t!==null&&this.field.value===Kr(t)?t:Ps(this.field.value);Number.isFinite(i)&&i!==t?this.setValue(i):this.updateDisplay()}updateDisplay(){let t=this.getValue();this.sliding||(this.slider.value=String(t===null?0:Ku*Bm(this.scale,t)));let e=t===null?"":Kr(t);(document.activeElement!==this.field||this.sliding)&&(this.field.value=e,this.field.placeholder=t===null?"differ":"");let i=t===null?"":String(t);return this.field.toggleAttribute("title",e!==i),e!==i&&(this.field.title=i),this}disable(t=!0){return this.slider.disabled=this.field.disabled=t,super.disable(t)}},Dl=class extends $m{constructor(t,e,i){super(t,e,"value","vector"),this.fields=["x","y","z"].map(s=>H("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} ${s} [${i.unit}]`,onchange:()=>this.commit()})),this.$widget.append(...this.fields),this.updateDisplay()}commit(){let t=this.getValue()??[],e=this.fields.map(({value:i},s)=>i===this.text(t[s])?t[s]:Ps(i));e.every(Number.isFinite)?this.setValue(e):this.updateDisplay()}updateDisplay(){let t=this.getValue()??["","",""];return this.fields.forEach((e,i)=>{document.activeElement!==e&&(e.value=this.text(t[i]),e.title=`${"xyz"[i]}: ${t[i]}`)}),this}text(t){return typeof t=="number"?Kr(t,oM):""}disable(t=!0){for(let e of this.fields)e.disabled=t;return super.disable(t)}};var Fl=class{constructor(t,e){this.session=t,this.host=e,this.gui=null,this.rows=new Map,this.queue=new Map,this.asked=new Set,this.rope="",this.built="",this.closed=new Map,t.on("parameters",i=>this.build(i))}build(t){let e=JSON.stringify(t.map(i=>[i.name,i.kind,i.unit,i.choices,i.group,i.more,i.label,Object.keys(i.values??{})]));e===this.built&&this.gui?this.refresh(t):this.rebuild(t,e)}rebuild(t,e){let i=this.host.scrollTop;this.built=e,this.gui?.destroy(),this.rows.clear(),this.gui=new Ll({container:this.host,injectStyles:!1,title:"Change it while it runs"});let s=[...new Set(t.flatMap(o=>Object.keys(o.values??{})))];s.includes(this.rope)||(this.rope=""),s.length>1&&this.addRopeChoice(this.gui,s);for(let o of t)o.more||this.addRow(this.gui,o);let r=t.filter(({more:o})=>o);if(r.length){let o=this.addFolder(this.gui,"More",!0);for(let a of[...new Set(r.map(l=>l.group))]){let l=this.addFolder(o,a,a==="Air"||a==="Ground");for(let c of r)c.group===a&&this.addRow(l,c)}}this.host.scrollTop=i}addFolder(t,e,i){let s=t.addFolder(e);return s.onOpenClose(r=>{r===s&&this.closed.set(e,s._closed)}),(this.closed.get(e)??i)&&s.close(),s}addRopeChoice(t,e){let i=Object.fromEntries([["all ropes",""],...e.map(s=>[s,s])]);t.add(this,"rope",i).name("Change").onChange(()=>this.refresh(this.session.parameters))}addRow(t,e){let i={value:this.valueOf(e)},s;if(e.kind==="choice"){let c=(e.choices??[]).map(({value:d,label:u})=>[u,d]);s=t.add(i,"value",Object.fromEntries(c))}else e.kind==="flag"?s=t.add(i,"value"):e.kind==="vector"?s=new Dl(t,i,e):s=new Nl(t,i,e);let r=Fr(e.unit),o=H("button",{type:"button",className:"back",onclick:()=>this.set(e.name,null)},mn("undo")),a=H("div",{className:"fault",hidden:!0,role:"alert"});s.name(""),s.$name.append(H("span",{},e.label),r&&H("em",{},r),o),s.domElement.append(a),s.domElement.dataset.parameter=e.name,s.onChange(c=>this.set(e.name,c));let l={parameter:e,holder:i,controller:s,back:o,fault:a};this.rows.set(e.name,l),this.show(l)}valueOf(t){return this.rope&&t.values&&this.rope in t.values?t.values[this.rope]:t.value}show(t){let{parameter:e,controller:i,holder:s,back:r}=t;t.controller.parameter=e,s.value=this.valueOf(e),i.updateDisplay(),i.disable(!e.enabled);let o=Ju(e.default),a=Ju(s.value)!==o;r.classList.toggle("unused",!a),r.disabled=!a||!e.enabled,r.title=`Back to ${o||"the scene's"} ${Fr(e.unit)}`.trim(),r.setAttribute("aria-label",`${e.label}: back to the scene's value`),i.domElement.title=e.enabled?e.help:e.why||e.help}refresh(t){for(let e of t){let i=this.rows.get(e.name);i&&(i.parameter=e,this.busy(e.name)||this.show(i))}}busy(t){return this.queue.has(t)||this.asked.has(t)||this.rows.get(t)?.controller.sliding}set(t,e){this.queue.size||requestAnimationFrame(()=>this.flush()),this.queue.set(t,e)}flush(){for(let[t,e]of this.queue)this.asked.has(t)||(this.queue.delete(t),this.send(t,e))}async send(t,e){let i=this.rows.get(t);this.asked.add(t);try{let o=this.rope&&i?.parameter.values?this.rope:null;await this.session.ask({type:"set",name:t,value:e,rope:o}),this.fault(t,"")}catch(o){this.fault(t,o.text)}if(this.asked.delete(t),this.queue.has(t)){this.flush();return}let s=this.rows.get(t),r=this.session.parameters.find(o=>o.name===t);s&&r&&!s.controller.sliding&&(s.parameter=r,this.show(s))}fault(t,e){let i=this.rows.get(t);i&&(i.fault.hidden=e==="",i.fault.textContent=e)}};function Ju(n){return n==null?"":typeof n=="number"?String(Number(n.toPrecision(6))):Array.isArray(n)?`[${n.map(Ju).join(", ")}]`:String(n)}var Ul=class{constructor(t,e){this.stage=t;let i=(s,r)=>H("button",{type:"button",className:"plain letter",id:`view-${s.toLowerCase()}`,title:`Look along the ${s.toLowerCase()} axis; again: from the other side`,"aria-label":`Look along the ${s.toLowerCase()} axis`,onclick:()=>this.along(r)},s);e.append(H("div",{className:"toolbar views",role:"toolbar","aria-label":"View"},xi("fit","Show everything",()=>t.fit(),{key:"F",id:"view-fit"}),i("X",0),i("Y",1),i("Z",2),H("button",{type:"button",className:"plain letter",id:"view-home",title:"The first view","aria-label":"The first view",onclick:()=>this.home()},"3D")))}along(t){let{camera:e}=this.stage,i=t===1&&Math.abs(e.up[1])<.9?-1:1,s=e.along(t,i),r=Math.abs(e.toward[t]-i)<.001;this.stage.fit(r?e.along(t,i===1?-1:1):s)}home(){let{layout:t}=this.stage.session;t&&this.stage.fly(this.stage.firstPose(t))}};var sr=class{constructor(t){this.shown=new Float32Array(t),this.from=new Float32Array(t),this.to=new Float32Array(t),this.arrival=0,this.spacing=1e3/60,this.part=1,this.empty=!0}next(t,e=!1){let i=t-this.arrival;return this.arrival=t,this.empty||e?(this.empty=!1,this.part=1-1e-9,this.arrival=-1/0,this.to):(i<250&&(this.spacing+=.15*(Math.max(4,i)-this.spacing)),this.from.set(this.shown),this.part=0,this.to)}advance(t){if(this.empty||this.part>=1)return!1;this.part=Math.min(1,Math.max(this.part,(t-this.arrival)/this.spacing));let{shown:e,from:i,to:s,part:r}=this;if(r>=1)e.set(s);else for(let o=0;o<e.length;o++)e[o]=i[o]+r*(s[o]-i[o]);return!0}};var ju=28*Math.PI/180,aM=.72,lM=.35,cM=.68,Ol=Math.PI/2,kl=class n{constructor(){this.width=1,this.height=1,this.pose={target:[0,0,0],distance:5,azimuth:-Ol+.5,elevation:.22},this.view=new Float32Array(16),this.projection=new Float32Array(16),this.version=0,this.up=[0,0,1],this.first=[1,0,0],this.second=[0,1,0],this.light=[0,0,1],this.eye=[0,0,0],this.right=[1,0,0],this.top=[0,0,1],this.toward=[0,-1,0],this.update()}setUp(t){this.up=Wa(t);let e=Math.abs(this.up[0])<.9?[1,0,0]:[0,0,1];this.first=Wa(En(e,Ze(this.up,$e(e,this.up)))),this.second=Uo(this.up,this.first);let i=ae(Ze(this.first,-.45),this.second,-.55);this.light=Wa(ae(i,this.up)),this.update()}resize(t,e){this.width=Math.max(1,t),this.height=Math.max(1,e),this.update()}set(t){let e={...this.pose,...t},{target:i,distance:s,azimuth:r,elevation:o}=e;[...i,s,r,o].every(Number.isFinite)&&(this.pose=e,this.pose.elevation=Math.min(Ol,Math.max(-Ol,this.pose.elevation)),this.pose.distance=Math.min(1e7,Math.max(1e-4,this.pose.distance)),this.update())}update(){let{target:t,distance:e,azimuth:i,elevation:s}=this.pose,[r,o]=[Math.cos(i),Math.sin(i)],[a,l]=[Math.cos(s),Math.sin(s)],c=ae(Ze(this.first,r),this.second,o);this.toward=ae(Ze(c,a),this.up,l),this.right=ae(Ze(this.first,-o),this.second,r),this.top=Uo(this.toward,this.right),this.eye=ae(t,this.toward,e);let d=[this.right,this.top,this.toward];for(let g=0;g<3;g++){for(let _=0;_<3;_++)this.view[4*_+g]=d[g][_];this.view[12+g]=-$e(d[g],this.eye),this.view[4*g+3]=0}this.view[15]=1;let u=e*.01,h=e*200,f=1/Math.tan(ju/2);this.projection.fill(0),this.projection[0]=f*this.height/this.width,this.projection[5]=f,this.projection[10]=(h+u)/(u-h),this.projection[11]=-1,this.projection[14]=2*h*u/(u-h),this.version++}get focal(){return this.height/2/Math.tan(ju/2)}project(t,e,i){let s=this.view,r=-(s[2]*t+s[6]*e+s[10]*i+s[14]),o=this.focal/Math.max(r,1e-9);return[this.width/2+(s[0]*t+s[4]*e+s[8]*i+s[12])*o,this.height/2-(s[1]*t+s[5]*e+s[9]*i+s[13])*o,r]}eyeHeight(t){return $e(this.eye,this.up)-t}ray(t,e){let i=(t-this.width/2)/this.focal,s=(this.height/2-e)/this.focal;return ae(ae(Ze(this.toward,-1),this.right,i),this.top,s)}inPlane(t,e,i){let s=$e(En(this.eye,i),this.toward);return ae(this.eye,this.ray(t,e),s)}onPlane(t,e,i,s){let r=this.ray(t,e);return s<0||Math.abs(r[s])<lM?this.inPlane(t,e,i):ae(this.eye,r,(i[s]-this.eye[s])/r[s])}orbit(t,e){let i=1.2*Math.PI/Math.min(this.width,this.height);this.set({azimuth:this.pose.azimuth-t*i,elevation:this.pose.elevation+e*i})}pan(t,e){let i=this.pose.distance/this.focal,s=ae(ae(this.pose.target,this.right,-t*i),this.top,e*i);this.set({target:s})}zoom(t,e=this.width/2,i=this.height/2){let s=this.inPlane(e,i,this.pose.target);this.set({distance:this.pose.distance*t});let r=this.inPlane(e,i,this.pose.target);this.set({target:ae(this.pose.target,En(s,r))})}at(t){let e=new n;return e.setUp(this.up),e.resize(this.width,this.height),e.set({...this.pose,...t}),e}fitted(t,e={},i){let s=Array.from({length:8},(r,o)=>Li([0,1,2].map(a=>o>>a&1?t.high[a]:t.low[a])));return this.framed(s,e,i)}framed(t,e={},{top:i,bottom:s}={top:0,bottom:0}){let r=this.at({...e,target:[0,0,0],distance:1}),o=Math.tan(ju/2),a=Math.max(.3,1-(i+s)/this.height),l=o*cM*a,c=o*aM*this.width/this.height,[d,u,h,f]=[-1/0,-1/0,-1/0,-1/0],[g,_]=[-1/0,1/0];for(let R of t){let[T,v,E]=[r.right,r.top,r.toward].map(k=>$e(R,k));d=Math.max(d,T+c*E),u=Math.max(u,c*E-T),h=Math.max(h,v+l*E),f=Math.max(f,l*E-v),g=Math.max(g,E),_=Math.min(_,E)}let m=Math.max((d+u)/(2*c),(h+f)/(2*l),g+.001),p=(g+_)/2,y=m-p,A=(i-s)/2*(y/this.focal),M=ae(ae(Ze(r.right,(d-u)/2),r.top,(h-f)/2+A),r.toward,p);return{...r.pose,target:M,distance:y}}along(t,e=1){let i=[0,0,0];return i[t]=e,this.angles(i)}angles(t){let e=$e(t,this.up),i=$e(t,this.first),s=$e(t,this.second);return{azimuth:Math.hypot(i,s)>1e-6?Math.atan2(s,i):-Ol,elevation:Math.atan2(e,Math.hypot(i,s))}}};var hM=320,qm=1600,Bl=class{constructor(t,e,i,s=hM){this.duration=s;let r=e.azimuth-t.azimuth;this.from=t,this.to=e,this.turn=r-2*Math.PI*Math.round(r/(2*Math.PI)),this.start=i}at(t){let e=Math.min(1,Math.max(0,(t-this.start)/this.duration)),i=e*e*(3-2*e),{from:s,to:r}=this;return{over:e>=1,pose:{target:ae(s.target,En(r.target,s.target),i),distance:s.distance*(r.distance/s.distance)**i,azimuth:s.azimuth+i*this.turn,elevation:s.elevation+i*(r.elevation-s.elevation)}}}};var uM=4,dM=4,fM=300,Ym=.95,pM=.75,zl=class{constructor(){this.low=[1/0,1/0,1/0],this.high=[-1/0,-1/0,-1/0],this.angles=""}clear(){this.low.fill(1/0),this.high.fill(-1/0)}take(t,e,i,s,{center:r,radius:o}){let a=`${t.pose.azimuth} ${t.pose.elevation}`;a!==this.angles&&this.clear(),this.angles=a;let l=[t.right,t.top,t.toward],c=Math.max(1,Math.ceil(i/fM)),d=1-Math.exp(-s/uM);l.forEach(([u,h,f],g)=>{let _=r[0]*u+r[1]*h+r[2]*f,[m,p]=[1/0,-1/0];for(let y=0;y<i;y+=c){let A=e[4*y]*u+e[4*y+1]*h+e[4*y+2]*f;Math.abs(A-_)>dM*o||(A<m&&(m=A),A>p&&(p=A))}Number.isFinite(m+p)&&(this.low[g]=m<this.low[g]?m:this.low[g]+d*(m-this.low[g]),this.high[g]=p>this.high[g]?p:this.high[g]+d*(p-this.high[g]))})}wanted(t,e){if(!this.low.every(Number.isFinite))return null;let i=t.framed(this.corners(t),{},e);return i.distance<pM*t.pose.distance||this.leaves(t,e)?i:null}leaves(t,{top:e,bottom:i}){let{width:s,height:r}=t;return this.corners(t).some(o=>{let[a,l,c]=t.project(...o),d=Math.abs(a-s/2)/(s/2),u=(e+r-i)/2,h=Math.abs(l-u)/((r-e-i)/2);return c<=0||d>Ym||h>Ym})}corners({right:t,top:e,toward:i}){let{low:s,high:r}=this;return Array.from({length:8},(o,a)=>{let[l,c,d]=[0,1,2].map(u=>a>>u&1?r[u]:s[u]);return[0,1,2].map(u=>l*t[u]+c*e[u]+d*i[u])})}};function Zm(n,t,e,i){let s=t.first+t.nodes-1,r=n.map(({index:l})=>l).filter(l=>l>=t.first&&l<=s).sort((l,c)=>l-c),o=t.length/Math.max(1,t.segments),a=1/0;return r.forEach((l,c)=>{let d=e(l),u=$e(d,i),h=r[c+1];if(c===0&&(a=Math.min(a,u-(l-t.first)*o)),h===void 0){a=Math.min(a,u-(s-l)*o);return}let f=e(h),g=(h-l)*o,_=u-$e(f,i),m=Math.max(0,d.reduce((y,A,M)=>y+(A-f[M])**2,0)-_*_),p=Math.sqrt(Math.max(0,g*g-m));a=Math.min(a,u,u-(_+p)/2)}),a}var mM=.28,gM=1e4,_M=3e38;function Km(n,t,{center:e,radius:i}){let[s,r,o]=e,a=gM*i,l=d=>!(Math.abs(n[d]-s)<a&&Math.abs(n[d+1]-r)<a&&Math.abs(n[d+2]-o)<a),c=null;for(let d=0,u=0;d<t;d++,u+=4){if(!l(u)){Number.isFinite(n[u+3])||(n[u+3]=0);continue}if(d>0)c=n.subarray(u-4,u-1);else{let h=0;for(;h<t&&l(4*h);)h++;c=h<t?n.slice(4*h,4*h+3):e}n.set(c,u),n[u+3]=_M}}function Jm(n,t){let e={low:[1/0,1/0,1/0],high:[-1/0,-1/0,-1/0]};for(let i=0;i<t;i++)for(let s=0;s<3;s++){let r=n[4*i+s];r<e.low[s]&&(e.low[s]=r),r>e.high[s]&&(e.high[s]=r)}return e}function jm(n,t,e){let i=[0,1,2].filter(r=>n.high[r]-n.low[r]<1e-4*e);if(!i.length)return-1;let s=i.filter(r=>Math.abs(t[r])<.9);return s.length>1?s.includes(1)?1:s[s.length-1]:s.length?s[0]:i[0]}function Qm(n,t){if(t<0)return{azimuth:-Math.PI/2+.55,elevation:.3};if(Math.abs(n.up[t])>.9)return{azimuth:-Math.PI/2,elevation:Math.PI/2};let e=Li([0,0,0]);e[t]=1;let i=$e(Uo(n.up,e),[1,1,1])>=0?1:-1,{azimuth:s}=n.along(t,i);return{azimuth:s-mM,elevation:.14}}function tg(n,t,e){let i=t.ground?t.ground.height:e,s=Kf(n.pose.distance*.28/5),{target:r}=n.pose,o=Math.round($e(r,n.first)/s)*s,a=Math.round($e(r,n.second)/s)*s,l=ae(ae(Ze(n.first,o),n.second,a),n.up,i);return{height:i,solid:t.ground!==null,spacing:s,radius:14*s,center:l}}var xM=["background","horizon","grid","shadow","ground","anchor","hand","load","arrow","grab","pin","hover","node","post"],eg="ropewalk-theme";function ig(){let n=new URLSearchParams(location.search).get("theme")??vM();return n==="light"||n==="dark"?n:matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function vM(){try{return localStorage.getItem(eg)}catch{return null}}function Vl(n,t=!1){if(document.documentElement.dataset.theme=n,!!t)try{localStorage.setItem(eg,n)}catch{}}function Qu(){let n=document.documentElement.dataset.theme==="dark",t=getComputedStyle(document.documentElement);return{...Object.fromEntries(xM.map(i=>[i,Js(t.getPropertyValue(`--scene-${i}`).trim()||"#888888")])),rim:Qf(n),dark:n}}function rr(n){let t=Math.max(1,Math.min(1024,n));return[t,Math.max(1,Math.ceil(n/t))]}function yM(n,t){return t==="strain"?1/n.EA:t==="utilisation"?n.breaking_load?1/n.breaking_load:0:1}function ng(n,t,e,i,s){let r=0,[o,a]=[1/0,-1/0];return t.variants.forEach((l,c)=>{let d=n.parts[c],[u,h,f]=i[c],{positions:g}=d;for(let _=0,m=0,p=r;_<l.nodes;_++,m+=3,p+=4)s[p]=g[m]+u,s[p+1]=g[m+1]+h,s[p+2]=g[m+2]+f;if(e==="speed"){let _=en(t,d,"speed_high"),{greatestSpeed:m}=d.seen;for(let p=0;p<l.nodes;p++)s[r+4*p+3]=m[p]/65535*_;o=0,a=Math.max(a,_)}else if(e!=="plain"){let _=en(t,d,"tension_low"),m=(en(t,d,"tension_high")-_)/65535;for(let p of l.ropes){let y=yM(p,e),A=p.first+p.nodes-1,{greatestTension:M,leastTension:R}=d.seen,T=M[p.first],[v,E]=[1/0,-1/0];for(let k=p.first;k<=A;k++){let D=k<A?M[k]:T;s[r+4*k+3]=(_+m*.5*(T+D))*y,T=D,E=Math.max(E,D),k<A&&(v=Math.min(v,R[k]))}o=Math.min(o,(_+m*v)*y),a=Math.max(a,(_+m*E)*y)}}r+=4*l.nodes}),e==="utilisation"?{low:0,high:Math.max(1,a),most:Math.max(0,a)}:{low:o,high:a,most:Math.max(0,a)}}var MM=.12,SM=.1,bM=4,Hl=class{constructor(t){this.stage=t,this.height=0,this.goal=0}get level(){return this.stage.session.layout?.ground?.height??this.height}put(t,e){let{camera:i,nodes:s,starts:r}=this.stage,{up:o}=i,a=h=>Li(s.to.subarray(4*h,4*h+3)),l=t.variants.flatMap(({ropes:h,anchors:f},g)=>h.map(_=>Zm(f,_,m=>a(r[g]+m),o))),c=Math.hypot(...e.high.map((h,f)=>h-e.low[f])),d=Math.min(...[e.low,e.high].map(h=>$e(h,o))),u=Math.min(...l,d)-MM*c;Number.isFinite(u)&&(this.height=this.goal=u)}giveWay(t){if(t.ground)return;let{up:e}=this.stage.camera,{to:i}=this.stage.nodes,{center:s,radius:r}=t.view,o=1/0;for(let a=0;a<4*Zi(t);a+=4)o=Math.min(o,i[a]*e[0]+i[a+1]*e[1]+i[a+2]*e[2]);o>=this.height||o<$e(s,e)-bM*r||(this.goal=Math.min(this.goal,o-SM*r))}advance(){let t=this.goal-this.height,{layout:e}=this.stage.session;t===0||!e||(this.height+=Math.abs(t)<.003*e.view.radius?t:.08*t,this.stage.dirty=!0)}};var Gl=class{constructor(t,e){this.nodes=t,this.colours=e,this.points=new Float32Array(4*360*t.length),this.head=0,this.version=0,this.empty=!0}push(t){let e=this.empty?360:1;for(let i=0;i<e;i++)this.nodes.forEach((s,r)=>{let o=4*(r*360+this.head);for(let a=0;a<3;a++)this.points[o+a]=t[4*s+a]}),this.head=(this.head+1)%360;this.empty=!1,this.version++}clear(){this.empty=!0,this.version++}};var sg=84,rg=8,wM=24,EM=new Set(["fixed","velocity","table"]),TM=5,AM=(n,t)=>`${Ne(n,"N")}${t>0&&n>.995*t?" (no more)":""}`,Wl=class{constructor(t){this.stage=t,this.dirty=!0,this.reactions=!0,this.trails=null,this.followed=new Set,this.hover=null,this.chosen=null,this.kick=null,this.strongest=0,this.most=[],this.labels=[],this.posts=[],this.standing=!0}setLayout(t){let e=t.variants[0].nodes;for(let i of this.followed)i>=e&&this.followed.delete(i);this.resetTrails(),this.strongest=0,this.most=[],this.hover=this.kick=this.chosen=null}take({parts:t}){this.most=t.map(({seen:e},i)=>Array.from(e.greatestForce,(s,r)=>Math.max(s,this.most[i]?.[r]??0)))}written(){this.most=[]}toggleTrail(t){this.followed.delete(t)||this.followed.add(t),this.followed.size>8&&this.followed.delete([...this.followed][0]),this.resetTrails()}resetTrails(){let t=[...this.followed],e=t.map((i,s)=>Js(qe[(s+1)%qe.length]));this.trails=t.length?new Gl(t,e):null,this.dirty=!0}collect(){let t=[],e=[];this.labels=[],this.posts=[];let{session:i}=this.stage;return i.layout&&i.frame&&(this.addAnchors(t,e),this.addLoads(t),this.addForces(e),this.addGrabs(t,e),this.addHand(t,e)),{markers:t,arrows:e}}addAnchors(t,e){let{session:i,theme:s,anchors:r,camera:o}=this.stage,a=i.layout,l=i.frame,d=Math.min(sg,.14*o.width)*o.pose.distance/o.focal,u=0,h=0,f=[];if(a.variants.forEach((g,_)=>{let m=l.parts[_];g.anchors.forEach((p,y)=>{let A=Li(r.shown.subarray(u,u+3));if(u+=3,m.anchors[10*y+9]<.5||!A.every(Number.isFinite))return;let[M,R,T]=A,v=p.pinned?s.pin:p.motion==="hand"?s.hand:s.anchor,E=p.pinned?14:19;t.push({x:M,y:R,z:T,kind:"eye",colour:v,size:0,pixels:E}),EM.has(p.motion)&&this.addPost(A);let k=[...m.anchors.subarray(10*y+6,10*y+9)],D=Math.hypot(...k);if(Number.isFinite(D)&&(h=Math.max(h,D),_===0||this.stage.apart)){let L=Math.max(D,m.seen.greatestForce[y],this.most[_]?.[y]??0);f.push({place:A,force:k,size:D,most:L})}})}),!!this.reactions){this.strongest=Math.max(h,this.strongest*.995);for(let{place:g,force:_,size:m,most:p}of f){if(m<.04*this.strongest||m<1e-9)continue;let y=ae(g,_,d/this.strongest);e.push({from:g,to:y,colour:s.arrow,pixels:2.6,head:!0}),f.length<=rg&&this.labels.push({from:g,at:y,text:Ne(p,"N"),kind:"reaction"})}}}addPost(t){let{camera:e,theme:i,floor:s}=this.stage,r=$e(t,e.up)-s.level,o=TM*e.pose.distance/e.focal;if(!this.standing||r<2*o||this.posts.length>=2*wM)return;let a=ae(t,e.up,-r),l=ae(a,e.toward,.3*o);this.posts.push({from:t,to:a,colour:i.post,pixels:4.5,head:!1},{from:ae(l,e.up,o),to:l,colour:i.post,pixels:16,head:!1})}addLoads(t){let{session:e,theme:i,nodes:s,starts:r}=this.stage;e.layout.variants.forEach((a,l)=>{let c=a.ropes.reduce((d,u)=>d+u.mass,0);for(let d of a.loads){let u=4*(r[l]+d.index),[h,f,g]=s.shown.subarray(u,u+3),_=9+11*Math.min(1.6,Math.cbrt(d.mass/Math.max(c,1e-9)));t.push({x:h,y:f,z:g,kind:"round",colour:i.load,size:0,pixels:_})}});for(let[a,l]of[...this.followed].entries()){let[c,d,u]=s.shown.subarray(4*l,4*l+3),h=Js(qe[(a+1)%qe.length]);t.push({x:c,y:d,z:u,kind:"round",colour:h,size:0,pixels:8})}}addForces(t){let{session:e,theme:i,nodes:s,camera:r}=this.stage,{forces:o}=e.layout.variants[0];if(!this.reactions||!o.length)return;let a=Math.max(...o.map(({force:c})=>Math.hypot(...c))),l=.6*sg*r.pose.distance/r.focal;for(let{index:c,force:d}of o){let u=Math.hypot(...d);if(!(u>0))continue;let h=Li(s.shown.subarray(4*c,4*c+3)),f=ae(h,d,l/a);t.push({from:h,to:f,colour:i.load,pixels:2.6,head:!0}),o.length<=rg&&this.labels.push({from:h,at:f,text:Ne(u,"N"),kind:"given"})}}addGrabs(t,e){let{session:i,theme:s,nodes:r,starts:o,shifts:a}=this.stage;i.frame.parts.forEach((c,d)=>{for(let u=0;u<c.grabs.length;u+=8){let h=c.grabs[u];if(!(h>=0))continue;let f=4*(o[d]+h),g=Li(r.shown.subarray(f,f+3)),_=ae(c.grabs.subarray(u+1,u+4),a[d]);e.push({from:g,to:_,colour:s.grab,pixels:2,head:!1}),t.push({x:_[0],y:_[1],z:_[2],kind:"ring",colour:s.grab,size:0,pixels:16});let[m,p,y]=c.grabs.subarray(u+4,u+7);if(d>0)continue;let A=AM(Math.hypot(m,p,y),c.grabs[u+7]);this.labels.push({from:g,at:_,text:A,kind:"grab"})}})}addHand(t,e){let{theme:i}=this.stage,s=this.chosen&&Bo(this.stage,this.chosen);for(let l of[this.ringPlace(),s]){if(!l)continue;let[c,d,u]=l;t.push({x:c,y:d,z:u,kind:"ring",colour:i.hover,size:0,pixels:24})}if(!this.kick)return;let{from:r,to:o,text:a}=this.kick;e.push({from:r,to:o,colour:i.grab,pixels:3,head:!0}),this.labels.push({from:r,at:o,text:a,kind:"kick"})}ringPlace(){let{hover:t,stage:e}=this;return t===null||Array.isArray(t)?t:Bo(e,t)}get scale(){return Ne(this.strongest,"N")}};var RM=60,CM=1,Xl=class{constructor(t,e){this.session=t,this.renderer=e,this.camera=new kl,this.nodes=new sr(4),this.anchors=new sr(0),this.range=new Oo,this.colouring="tension",this.most=0,this.dots=!1,this.apart=!1,this.shifts=[[0,0,0]],this.starts=[0],this.corners=new Uint8Array(0),this.theme=Qu(),this.marks=new Wl(this),this.dirty=!0,this.drawn=0,this.spacing=1,this.floor=new Hl(this),this.flight=null,this.follower=new zl,this.following=!0,this.ownVersion=-1,this.axis=-1,this.past=!1,this.lookPending=!0,this.layoutNumber=-1,this.up=[0,0,1],this.sceneKey="",this.lastTime=-1/0,this.lastPush=0,this.cameraVersion=-1,this.card=()=>null,this.beforeDraw=[],this.afterDraw=[],t.on("layout",s=>this.takeLayout(s)),t.on("frame",s=>this.takeFrame(s)),t.on("broken",()=>{this.range.fresh=!0,this.past=t.broken!==null}),e.setTheme(this.theme),e.canvas.addEventListener("webglcontextrestored",()=>this.setTheme());let i=s=>{requestAnimationFrame(i),this.tick(s)};requestAnimationFrame(i)}takeLayout(t){if(this.dirty=!0,t.layout===this.layoutNumber){this.follow(t);return}this.layoutNumber=t.layout,this.starts=_l(t);let e=Zi(t),[i,s]=rr(e);this.nodes=new sr(4*i*s),this.anchors=new sr(3*t.variants.reduce((o,{anchors:a})=>o+a.length,0)),this.up=t.up,this.camera.setUp(t.up),this.renderer.setShape(Fm(t)),this.corners=Um(t),this.marks.setLayout(t);let r=`${t.scene.name} ${t.scene.preset} ${t.variants.length>1&&this.apart}`;r!==this.sceneKey&&(this.sceneKey=r,this.lookPending=!0,this.range.fresh=!0),this.shift(t)}follow({up:t,gravity:e}){t.every((s,r)=>Math.abs(s-this.up[r])<1e-6)||e.every(s=>s===0)||(this.up=t,this.camera.setUp(t),this.lookPending=!0)}shift(t){let e=this.lookPending?this.camera.first:this.camera.right;this.shifts=Om(t,this.apart,e,2.1*t.view.radius)}setApart(t){this.apart=t;let{layout:e,frame:i}=this.session;e&&(this.shift(e),this.lookPending=!0,i&&this.takeFrame(i,!0))}takeFrame(t,e=!1){let i=this.session.layout,s=performance.now(),r=e||t.time<this.lastTime||!(t.flags&1);t.time<this.lastTime&&this.marks.trails?.clear(),(t.time<this.lastTime||t.time>this.lastTime+CM)&&(this.range.fresh=!0,this.marks.strongest=0),this.lastTime=t.time;let o=this.nodes.next(s,r),a=ng(t,i,this.colouring,this.shifts,o);Km(o,Zi(i),i.view),this.past=this.session.broken!==null||(t.flags&2)!==0,t.flags&2||(this.most=a.most,this.range.follow(a.low,a.high,Math.min(.2,(s-this.lastPush)/1e3))),this.lastPush=s,e||this.marks.take(t),this.gatherAnchors(t,this.anchors.next(s,r)),this.lookPending?this.look(i):this.keepInView(i,s),this.marks.trails&&this.marks.trails.push(this.nodes.to),this.dirty=!0}showInstead(t,e=0){let{frame:i}=this.session;if(!i)return;if(!t)return this.takeFrame(i,!0);let s=Float32Array.from(t.flat()),r=i.parts.map((o,a)=>a===e&&s.length===o.positions.length?{...o,positions:s}:o);this.takeFrame({...i,parts:r,flags:i.flags|2},!0)}gatherAnchors(t,e){let i=0;t.parts.forEach((s,r)=>{for(let o=0;o<s.anchors.length;o+=10)for(let a=0;a<3;a++)e[i++]=s.anchors[o+a]+this.shifts[r][a]})}look(t){this.lookPending=!1;let e=Jm(this.nodes.to,Zi(t));this.axis=jm(e,this.camera.up,t.view.radius),this.floor.put(t,e),this.follower.clear(),this.setPose(this.firstPose(t)),this.following=!0,this.flight=null}keepInView(t,e){if(this.past)return;let{camera:i,follower:s}=this,r=Math.min(.2,(e-this.lastLook)/1e3);if(this.lastLook=e,s.take(i,this.nodes.to,Zi(t),r,t.view),this.floor.giveWay(t),i.version!==this.ownVersion&&!this.flight&&(this.following=!1),!this.following||this.flight||this.held())return;let o=s.wanted(i,this.strips());o&&this.fly(o,qm)}get leastWidth(){return this.session.layout&&Zi(this.session.layout)>4e3?4:8}thickness(){let{camera:t,session:e}=this,i=e.layout?.variants.flatMap(r=>r.ropes)??[],s=Math.max(1e-9,...i.map(r=>r.diameter));return Math.max(1,this.leastWidth*t.pose.distance/t.focal/s)}held=()=>!1;lastLook=0;windowShape=innerWidth/innerHeight;setPose(t){this.camera.set(t),this.ownVersion=this.camera.version}firstPose(t){let e=Qm(this.camera,this.axis),i=this.camera.framed(this.places(t),e);return this.covered(i)?this.wholePose(t,e):i}wholePose(t,e){return this.camera.framed(this.places(t),e,this.strips())}*places(t){let{to:e}=this.nodes;for(let i=0;i<Zi(t);i++)yield Li(e.subarray(4*i,4*i+3))}fit(t={}){let{layout:e}=this.session;!e||this.nodes.empty||(this.following=!0,this.follower.clear(),this.fly(this.wholePose(e,t)))}uncover(){!this.lookPending&&this.covered(this.camera.pose)&&this.fit()}covered(t){let{layout:e}=this.session,i=this.card();if(!e||!i)return!1;let s=this.camera.at(t);for(let r=0;r<Zi(e);r++){let[o,a]=s.project(...Li(this.nodes.to.subarray(4*r,4*r+3)));if(o>i.left&&o<i.right&&a>i.top&&a<i.bottom)return!0}return!1}strips(){let t=this.card();if(!t)return{top:0,bottom:0};let e=this.camera.height-t.top;return t.bottom<e?{top:t.bottom,bottom:0}:{top:RM,bottom:e}}fly(t,e){this.ownVersion=this.camera.version,matchMedia("(prefers-reduced-motion: reduce)").matches?this.setPose(t):this.flight=new Bl(this.camera.pose,t,performance.now(),e)}setColouring(t){this.colouring=t,this.range=new Oo,this.session.frame&&this.takeFrame(this.session.frame,!0)}setTheme(){this.theme=Qu(),this.renderer.setTheme(this.theme),this.dirty=!0}resize(t,e){let i=this.camera.version===this.ownVersion;this.camera.resize(t,e),i&&(this.ownVersion=this.camera.version),this.renderer.resize(t,e,Math.min(2,devicePixelRatio||1));let s=innerWidth/innerHeight;this.following&&Math.abs(s/this.windowShape-1)>.3&&(this.lookPending=!0),this.windowShape=s,this.following&&this.uncover();let{layout:r,frame:o}=this.session;r&&o&&this.lookPending&&this.look(r),this.renderer.clear(),this.draw(!0)}tick(t){if(this.flight){let{pose:s,over:r}=this.flight.at(t);this.setPose(s),r&&(this.flight=null)}this.floor.advance();let e=this.nodes.advance(performance.now());this.anchors.advance(performance.now());let i=this.camera.version!==this.cameraVersion;(e||i||this.dirty||this.marks.dirty)&&this.draw(e||this.dirty),this.session.acknowledge()}draw(t){let{layout:e}=this.session;if(!e||this.nodes.empty)return;if(t)for(let o of this.beforeDraw)o();this.dirty=this.marks.dirty=!1,this.cameraVersion=this.camera.version;let{markers:i,arrows:s}=this.marks.collect(),r=tg(this.camera,e,this.floor.height);this.spacing=r.spacing,this.renderer.draw({camera:this.camera,nodes:this.nodes.shown,moved:t,range:this.range,plain:this.colouring==="plain",dots:this.dots,pixels:this.leastWidth,smooth:!this.past,corners:this.corners,markers:i,arrows:s,posts:this.marks.posts,trails:this.marks.trails,ground:r}),this.drawn++;for(let o of this.afterDraw)o()}screenOf(t,e=0){let i=4*(this.starts[e]+t),{shown:s}=this.nodes,[r,o,a]=this.camera.project(s[i],s[i+1],s[i+2]);return{x:r,y:o,depth:a}}};var og="(max-width: 700px), (max-height: 500px)",$l=class{constructor(t,e,i){this.session=e,this.root=t;let s=(a,l)=>H(a,{className:l,id:l});this.barHost=s("header","bar"),this.meterHost=s("section","meter"),this.scene=s("main","scene"),this.panel=s("aside","panel"),this.graphHost=s("section","graphs"),this.footer=s("footer","controls");let r=H("canvas",{id:"view",tabIndex:0,"aria-label":"The ropes"});this.scene.append(r),t.replaceChildren(this.barHost,this.meterHost,this.scene,this.panel,this.graphHost,this.footer),this.graphHost.hidden=!0,this.stage=new Xl(e,i(r)),this.labels=new El(this.stage,this.scene),this.notices=new Rl(e,this.scene),this.legend=new Tl(this.stage,this.scene),this.views=new Ul(this.stage,this.scene),this.graphs=new pl(this.stage,this.graphHost),this.tools=new Pl(this.stage,this.scene,a=>this.follow(a)),this.pointer=new Za(this.stage,this.stage.renderer.canvas,{use:(a,l)=>this.tools.use(a,l),menu:(a,l,c)=>this.tools.menu(a,l,c)}),this.tools.pointer=this.pointer;let o=H("div",{className:"unseen",role:"status",id:"voice"});this.scene.append(o),this.walk=new qa(this.stage,this.stage.renderer.canvas,o,(a,l,c)=>this.tools.menu(a,l,c)),this.stage.held=()=>this.pointer.down.size>0,this.meter=new Al(e,this.meterHost),this.controls=new Sl(e,this.footer,()=>this.graphs.toggle()),this.tweak=new Fl(e,this.panel),this.broken=new gl(e,this.scene,(...a)=>this.stage.showInstead(...a)),this.tour=new Il(e,this.scene),this.scenes=new Cl(e,t),this.compare=new xl(this.stage,t,this.scene,a=>this.compareColours(a)),this.help=new bl(t),this.keep=new wl(this.stage,t,this.notices),this.bar=new ml(this.barHost,{scenes:()=>this.scenes.open(),tour:()=>this.tour.start(),compare:()=>this.compare.open(),keep:a=>this.keep.open(a),help:()=>this.help.open(),theme:()=>this.toggleTheme(),panel:()=>this.togglePanel()}),this.keys=new Xa(e,this.stage.camera,this.shortcuts()),this.watchHand(),this.panel.hidden=matchMedia(og).matches,new ResizeObserver(()=>this.resize()).observe(this.scene),this.resize(),e.on("hello",()=>this.hello()),e.on("layout",({scene:a})=>this.bar.show(a.name)),e.on("status",({address:a})=>this.writeAddress(a)),this.asked=!1,addEventListener("hashchange",()=>this.openAddress())}shortcuts(){return{" ":()=>this.controls.toggle(),".":()=>this.controls.doStep(),r:()=>this.controls.doReset(),undo:()=>this.controls.doUndo(),f:()=>this.stage.fit(),g:()=>this.graphs.toggle(),p:()=>this.togglePanel(),t:()=>this.toggleTheme(),h:()=>this.help.open(),"?":()=>this.help.open()}}watchHand(){let{source:t}=this.session,e=t.send.bind(t);t.send=i=>{e(i),["drag","move","grab"].includes(i.type)&&this.tour.handMoved()}}hello(){let{session:t}=this,e=t.hello,i=this.stage.renderer.name==="webgl"?"WebGL":"Canvas 2D";this.help.version.textContent=`Ropewalk ${e.ropewalk}, drawn with ${i}.`,this.root.dataset.mode=e.mode,this.bar.compare.hidden=!t.can("compare"),this.bar.tour.hidden=!t.can("set"),this.bar.choose.disabled=!t.can("scene");let s=t.can("set");s||(this.panel.hidden=!0),this.bar.panel.hidden=!s,!this.asked&&location.hash.slice(1)!==e.address&&this.openAddress(),this.asked=!0,this.resize()}openAddress(){let{session:t}=this,e=location.hash.slice(1);e&&e!==t.status?.address&&t.can("scene")&&t.tell({type:"scene",address:e})}writeAddress(t){!this.session.source.base||!t||location.hash.slice(1)===t||history.replaceState(null,"",`#${t}`)}follow(t){this.stage.marks.toggleTrail(t),this.graphs.rebuild(),!this.graphs.open&&this.stage.marks.followed.size===1&&!matchMedia(og).matches&&this.graphs.toggle(!0)}compareColours(t){this.legend.select.value=t?"plain":"tension",this.legend.choose()}togglePanel(){this.panel.hidden=!this.panel.hidden,this.resize()}toggleTheme(){Vl(document.documentElement.dataset.theme==="dark"?"light":"dark",!0),this.stage.setTheme(),this.graphs.rebuild()}resize(){this.root.classList.toggle("with-panel",!this.panel.hidden);let{clientWidth:t,clientHeight:e}=this.scene;t&&e&&this.stage.resize(t,e)}};function ag(n){let{session:t,stage:e}=n;return{app:n,session:t,stage:e,get frames(){return t.frames},get drawn(){return e.drawn},get frame(){return t.frame?.number??-1},get time(){return t.frame?.time??NaN},get renderer(){return e.renderer.name},get state(){return t.connection!=="open"?t.connection:t.frame?t.broken?"broken":t.status?.playing?"playing":"paused":"waiting"},screenOf(i,s=0){let r=e.renderer.canvas.getBoundingClientRect(),{x:o,y:a}=e.screenOf(i,s);return{x:o+r.left,y:a+r.top}},nodeAt(i,s=0){let r=t.frame?.parts[s];return r?[...r.positions.subarray(3*i,3*i+3)]:null}}}var PM=900,IM=600,LM=120,Jr=class{constructor(t,e){this.app=t,this.read=e,this.timer=0,this.known="",this.until=-1,this.coarse=[],t.graphs.wanted=()=>this.want()}want(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.fill(),LM)}async fill(){let{graphs:t,session:e,stage:i}=this.app,{layout:s,frame:r}=e;if(!t.open||!s||!r||r.steps<1)return;let[o,a]=[r.steps,r.time],l=Math.min(t.window,a),c=Math.min(o,Math.ceil(l*o/Math.max(a,1e-9))),d=`${s.layout} ${[...i.marks.followed]}`;(d!==this.known||o>this.until)&&(this.coarse=await this.samples(0,o,IM,s),[this.known,this.until]=[d,o]);let u=await this.samples(o-c,c,PM,s);if(e.layout!==s||!e.frame||e.frame.time<a)return;let h=u[0]?.time??a,{history:f}=t;f.clear();for(let{time:g,values:_}of this.coarse)g<h&&f.add(g,_);for(let{time:g,values:_}of u)f.add(g,_);t.take(e.frame),t.bounds()}async samples(t,e,i,s){let r=Math.max(1,Math.ceil(e/i)),o=[...this.app.stage.marks.followed];return(await this.read(t,Math.ceil(e/r),r)).filter(c=>!(c.flags&2)).map(c=>({time:c.time,values:fl(s,c,o)}))}};var lg=40;function cg(n,t){let e=new Jr(n,(...s)=>NM(t,...s));t.jumped=()=>{n.stage.marks.trails?.clear(),e.want()};let{about:i}=t.header;n.help.window.append(H("p",{className:"faint",id:"about"},i))}async function NM(n,t,e,i){let s=n.parts[n.layout],r=[];for(let o=0;o<e;o++){let a=t+o*i;a<s.first||a>=s.first+s.frames||(r.push(Nr(n.frame(a,a-i),s.layout)),o%lg===lg-1&&await new Promise(l=>setTimeout(l)))}return r}var DM=.3;function hg(n){let{session:t,stage:e}=n,i=null,s=0;t.on("frame",({time:r})=>{if(t.hello?.mode!=="replay")return;i??=new Jr(n,(...a)=>FM(n,...a));let o=r<s||r>s+DM*Math.max(1,t.status?.speed??1);s=r,o&&(e.marks.trails?.clear(),i.want())})}async function FM({session:n},t,e,i){let s=n.layout;if(e<1)return[];let r=`replay/frames.bin?first=${t}&count=${e}&every=${i}`,o=await fetch(n.source.base+r).catch(()=>null);return o?.ok?UM(await o.arrayBuffer(),s).map(a=>Nr(a,s)):[]}function UM(n,t){let e=[];for(let i=n.byteLength;i>=t.bytes;i-=t.bytes){let s=n.slice(i-t.bytes,i);if($a(s)!==t.layout)break;e.push(s)}return e.reverse()}var td=[-.3,.4],Qo=new Float64Array(3),ta=new Float64Array(3);function fg(n,t,e,i,s,r){let o=t.first+t.count-1,a=4*r;for(let l=t.first;l<o;l++){let c=4*l,d=ed(n,c,c+4),u=l>t.first&&!i[l],h=l+1<o&&!i[l+1];u&&ug(n,c,c,d,Qo),h&&ug(n,c+4,c,d,ta);for(let f=0;f<3;f++){let g=n[c+4+f]-n[c+f];u||(Qo[f]=h?1.5*g-.5*ta[f]:g),h||(ta[f]=u?1.5*g-.5*Qo[f]:g)}dg(Qo,1.6*d),dg(ta,1.6*d);for(let f=0;f<e;f++,a+=4){let g=f/e,[_,m]=[g*g,g*g*g],[p,y,A]=[3*_-2*m,g-2*_+m,m-_];for(let M=0;M<3;M++){let R=n[c+M];s[a+M]=R+p*(n[c+4+M]-R)+y*Qo[M]+A*ta[M]}s[a+3]=n[c+3]+g*(n[c+7]-n[c+3])}}for(let l=0;l<4;l++)s[a+l]=n[4*o+l]}function ug(n,t,e,i,s){let r=ed(n,t-4,t),o=ed(n,t,t+4),a=Math.sqrt(i);if(!(r>0&&o>0)){for(let f=0;f<3;f++)s[f]=n[e+4+f]-n[e+f];return}let[l,c]=[Math.sqrt(r),Math.sqrt(o)],d=0;for(let f=0;f<3;f++)d+=(n[t+f]-n[t-4+f])*(n[t+4+f]-n[t+f])/(r*o);let u=Math.min(1,Math.max(0,(d-td[0])/(td[1]-td[0]))),h=u*u*(3-2*u);for(let f=0;f<3;f++){let[g,_,m]=[n[t-4+f],n[t+f],n[t+4+f]],p=(_-g)/l-(m-g)/(l+c)+(m-_)/c,y=n[e+4+f]-n[e+f];s[f]=y+h*(p*a-y)}}function dg(n,t){let e=Math.hypot(n[0],n[1],n[2]);if(e>t)for(let i=0;i<3;i++)n[i]*=t/e}function ed(n,t,e){return Math.hypot(n[e]-n[t],n[e+1]-n[t+1],n[e+2]-n[t+2])}function pg(n,t,e,i){let s=4*t,[r,o,a]=[1,0,0],[l,c,d]=[i[s],i[s+1],i[s+2]],u=!1;for(let h=0;h<e;h++,s+=4){if(h>0&&h+1===e){i[s]=l,i[s+1]=c,i[s+2]=d;break}let f=n[s+4]-n[s],g=n[s+5]-n[s+1],_=n[s+6]-n[s+2],m=Math.sqrt(f*f+g*g+_*_);if(m>0){let[p,y,A]=[f/m,g/m,_/m];if(u){let T=r*p+o*y+a*A;if(T>-.999){let v=(l*p+c*y+d*A)/(1+T);l-=v*(r+p),c-=v*(o+y),d-=v*(a+A)}}[r,o,a]=[p,y,A];let M=l*r+c*o+d*a;[l,c,d]=[l-M*r,c-M*o,d-M*a];let R=Math.sqrt(l*l+c*c+d*d);R>.001||([l,c,d]=Math.abs(a)<.9?[-o,r,0]:[0,-a,o],R=Math.sqrt(l*l+c*c+d*d)),l/=R,c/=R,d/=R,u=!0}i[s]=l,i[s+1]=c,i[s+2]=d}}var OM=7,id=1.5,kM=8,BM=16,jr=class{constructor(t,e){this.budget=t,this.laid=e,this.steps=0,this.every=1,this.nodes={nodes:0,ropes:[]},this.shape={nodes:0,ropes:[]},this.points=new Float32Array(4),this.normals=new Float32Array(4)}setShape(t){this.nodes=t,this.steps=0}update(t){let[e,i]=this.wanted(t),s=e!==this.steps||i!==this.every;return s&&this.build(e,i),!s&&!t.moved?!1:(this.nodes.ropes.forEach((r,o)=>{let{first:a,count:l}=this.shape.ropes[o];i>1?zM(t.nodes,r.first,r.count,i,this.points,a):e>1?fg(t.nodes,r,e,t.corners,this.points,a):this.points.set(t.nodes.subarray(4*r.first,4*(r.first+r.count)),4*a),this.framed&&pg(this.points,a,l,this.normals)}),s)}get framed(){return this.shape.nodes<=this.laid}wanted({camera:t,smooth:e,dots:i}){let{ropes:s,nodes:r}=this.nodes;if(!e||!r)return[1,1];let a=s.reduce((u,{spacing:h})=>Math.max(u,h),0)*t.focal/t.pose.distance;if(!i&&(a<id||this.every>1&&a<1.3*id)){let u=Math.min(BM,2**Math.round(Math.log2(2*id/a)));return[1,this.every>1&&u<4*this.every&&this.every<4*u?this.every:Math.max(2,u)]}let l=Math.max(1,Math.min(kM,Math.floor(this.budget/r))),c=Math.max(1,Math.min(l,Math.ceil(a/OM)));return[this.steps>=c&&this.steps<=Math.max(2,2*c)&&this.steps<=l?this.steps:c,1]}build(t,e){let i=this.shape.ropes.map(({first:l})=>this.normals.slice(4*l,4*l+3));[this.steps,this.every]=[t,e];let s=0,r=this.nodes.ropes.map(l=>{let c=s,d=Math.max(0,l.count-1),u=e>1?Math.ceil(d/e):d*t,h=l.count>0?u+1:0;return s+=h,{...l,first:c,count:h,spacing:l.spacing*d/Math.max(1,u)}});this.shape={nodes:s,ropes:r};let[o,a]=rr(s);this.points=new Float32Array(4*o*a),this.normals=new Float32Array(this.framed?4*o*a:4),this.framed&&r.forEach(({first:l,count:c,spacing:d},u)=>{i.length===r.length&&this.normals.set(i[u],4*l);for(let h=0;h<c;h++)this.normals[4*(l+h)+3]=h*d})}};function zM(n,t,e,i,s,r){let o=4*r;for(let l=0;l<e-1;l+=i,o+=4){let c=Math.min(l+i,e-1),d=4*(t+l),u=n[d+3];for(let h=l+1;h<c;h++)u=Math.max(u,n[4*(t+h)+3]);s[o]=n[d],s[o+1]=n[d+1],s[o+2]=n[d+2],s[o+3]=u}let a=4*(t+e-1);for(let l=0;l<4;l++)s[o+l]=n[a+l]}var ql=14,mg=8;function gg(n,t,e){let{width:i,height:s,focal:r}=t,o=s/2-r*Math.tan(Math.min(1.5,t.pose.elevation)),a=c=>Math.min(1,Math.max(0,c/s)),l=n.createLinearGradient(0,0,0,s);l.addColorStop(0,Ke(o>0?e.background:e.ground)),l.addColorStop(a(o),Ke(o>0?e.horizon:e.ground)),l.addColorStop(a(o+.35*s),Ke(e.ground)),n.fillStyle=l,n.fillRect(0,0,i,s)}function _g(n,t,e,i){n.lineWidth=1;let s=[[],[],[]];for(let[r,o]of[[t.first,t.second],[t.second,t.first]])for(let a=-ql;a<=ql;a++){let l=ae(e.center,r,a*e.spacing);for(let c=0;c<mg;c++){let[d,u]=[c,c+1].map(_=>(2*_/mg-1)*ql),h=Math.hypot(a,(d+u)/2)/ql;if(h>.95)continue;let f=t.project(...ae(l,o,d*e.spacing)),g=t.project(...ae(l,o,u*e.spacing));f[2]<=.02*t.pose.distance||g[2]<=.02*t.pose.distance||s[h<.45?0:h<.7?1:2].push(f[0],f[1],g[0],g[1])}}s.forEach((r,o)=>{n.strokeStyle=Ke(i.grid,[.8,.5,.2][o]),n.beginPath();for(let a=0;a<r.length;a+=4)n.moveTo(r[a],r[a+1]),n.lineTo(r[a+2],r[a+3]);n.stroke()})}function xg(n,t,e){let[i,s,r]=t.project(e.x,e.y,e.z);if(r<=0)return;let o=.5*Math.max(e.pixels,e.size*t.focal/r),a=e.colour.map(l=>.72*l);if(n.beginPath(),e.kind==="ring"){n.arc(i,s,o-1.2,0,2*Math.PI),n.lineWidth=2.4,n.strokeStyle=Ke(e.colour),n.stroke();return}if(e.kind==="eye"){n.arc(i,s,.7*o,0,2*Math.PI);for(let[l,c]of[[.65,a],[.4,e.colour]])n.lineWidth=l*o,n.strokeStyle=Ke(c),n.stroke();return}n.arc(i,s,o,0,2*Math.PI),n.fillStyle=Ke(e.colour),n.fill(),n.lineWidth=1.5,n.strokeStyle=Ke(a),n.stroke()}function nd(n,t,e){let[i,s,r]=t.project(e.from[0],e.from[1],e.from[2]),[o,a,l]=t.project(e.to[0],e.to[1],e.to[2]);if(r<=0||l<=0)return;let c=Math.hypot(o-i,a-s);if(c<1)return;let[d,u]=[(o-i)/c,(a-s)/c],h=e.head?Math.min(.5*c,5.5*e.pixels):0;if(n.lineCap="butt",n.lineWidth=e.pixels,n.strokeStyle=n.fillStyle=Ke(e.colour),n.beginPath(),n.moveTo(i,s),n.lineTo(o-h*d,a-h*u),n.stroke(),n.lineCap="round",!h)return;let f=2.2*e.pixels;n.beginPath(),n.moveTo(o,a),n.lineTo(o-h*d-f*u,a-h*u+f*d),n.lineTo(o-h*d+f*u,a-h*u-f*d),n.fill()}var ea=32,VM=1200,sd=6,ia=class{constructor(t){let e=t.getContext("2d",{alpha:!1});if(!e)throw new Error("no canvas to draw on");this.name="canvas",this.canvas=t,this.context=e,this.colours=[],this.line=new jr(VM,0),this.shape={nodes:0,ropes:[]},this.seen=new Float32Array(0),this.batch=new Uint8Array(0),this.ratio=1,this.theme=null}setShape(t){this.line.setShape(t)}setTheme(t){this.theme=t;let e=Ur(t.dark);this.colours=Array.from({length:ea},(i,s)=>Ke(e[Math.round(s/(ea-1)*(e.length-1))]))}resize(t,e,i){this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i),this.ratio=i}clear(){let{context:t,canvas:e,theme:i}=this;t.setTransform(1,0,0,1,0,0),t.fillStyle=i?Ke(i.background):"#888888",t.fillRect(0,0,e.width,e.height)}follow(t){this.line.update(t)&&(this.shape=this.line.shape,this.seen=new Float32Array(3*this.shape.nodes),this.batch=new Uint8Array(this.shape.nodes))}draw(t){let{context:e,theme:i}=this;if(i){this.follow(t),this.clear(),e.setTransform(this.ratio,0,0,this.ratio,0,0),e.lineJoin="round",e.lineCap="round",gg(e,t.camera,i),_g(e,t.camera,t.ground,i),this.shadows(t,i);for(let s of t.posts)nd(e,t.camera,s);this.project(t,null),t.trails&&!t.trails.empty&&this.trails(t),this.ropes(t),t.dots&&this.dots(i);for(let s of t.markers)xg(e,t.camera,s);for(let s of t.arrows)nd(e,t.camera,s)}}shadows(t,e){let{context:i}=this;this.project(t,t.ground.height),i.strokeStyle=Ke(e.shadow,e.dark?.5:.16);for(let s of this.shape.ropes)i.lineWidth=this.width(s,t)*1.2,i.beginPath(),this.path(s),i.stroke()}project(t,e){let{seen:i}=this,{camera:s}=t,{points:r}=this.line,o=s.view,[a,l,c]=s.up,d=ae(s.light,s.up,-$e(s.light,s.up)),[u,h,f]=ae(s.up,d,.75/$e(s.light,s.up)),[g,_,m]=[s.width/2,s.height/2,s.focal];for(let p=0;p<this.shape.nodes;p++){let[y,A,M]=[r[4*p],r[4*p+1],r[4*p+2]];if(e!==null){let v=y*a+A*l+M*c-e;y-=v*u,A-=v*h,M-=v*f}let R=-(o[2]*y+o[6]*A+o[10]*M+o[14]),T=m/Math.max(R,1e-9);i[3*p]=g+(o[0]*y+o[4]*A+o[8]*M+o[12])*T,i[3*p+1]=_-(o[1]*y+o[5]*A+o[9]*M+o[13])*T,i[3*p+2]=r[4*p+3]>1e30?-1:R}}width(t,e){let i=Math.max(1e-9,this.seen[3*(t.first+(t.count>>1))+2]);return Math.max(e.pixels,2*t.radius*e.camera.focal/i)}path(t){let{context:e,seen:i}=this,s=!1;for(let r=t.first;r<t.first+t.count;r++){let o=i[3*r+2]<=0;s&&!o?e.lineTo(i[3*r],i[3*r+1]):e.moveTo(i[3*r],i[3*r+1]),s=!o}}ropes(t){let{context:e}=this,i=this.theme;for(let s of this.shape.ropes){let r=this.width(s,t);if(t.plain){e.lineWidth=r,e.strokeStyle=Ke(s.colour),e.beginPath(),this.path(s),e.stroke();continue}this.coloured(s,t,r),r>6&&(e.lineWidth=r*.25,e.strokeStyle=i.dark?"rgba(255, 255, 255, 0.18)":"rgba(255, 255, 255, 0.3)",e.beginPath(),this.path(s),e.stroke())}}coloured(t,e,i){let{context:s,seen:r,batch:o}=this,{points:a}=this.line,{low:l,high:c}=e.range,d=ea/Math.max(c-l,1e-30),u=t.first+t.count-1;for(let h=t.first;h<u;h++){let f=.5*(a[4*h+3]+a[4*h+7]);o[h]=Math.min(ea-1,Math.max(0,Math.floor((f-l)*d)))}s.lineWidth=i;for(let h=0;h<ea;h++){let f=!1,g=!1;for(let _=t.first;_<u;_++){if(!(o[_]===h)||!(r[3*_+2]>0&&r[3*_+5]>0)){f=!1;continue}g||s.beginPath(),f||s.moveTo(r[3*_],r[3*_+1]),s.lineTo(r[3*_+3],r[3*_+4]),f=g=!0}g&&(s.strokeStyle=this.colours[h],s.stroke())}}dots(t){let{context:e,seen:i}=this;e.fillStyle=Ke(t.node),e.beginPath();for(let{first:s,count:r}of this.shape.ropes)for(let o=s;o<s+r;o+=this.line.steps)i[3*o+2]<=0||(e.moveTo(i[3*o]+2.2,i[3*o+1]),e.arc(i[3*o],i[3*o+1],2.2,0,2*Math.PI));e.fill()}trails(t){let e=t.trails,{context:i}=this;i.lineWidth=2.5;let s=360/sd;e.nodes.forEach((r,o)=>{for(let a=0;a<sd;a++){i.strokeStyle=Ke(e.colours[o],.7*((a+1)/sd)**2),i.beginPath();for(let l=a*s;l<=Math.min((a+1)*s,359);l++){let c=4*(o*360+(e.head+l)%360),d=e.points,[u,h,f]=t.camera.project(d[c],d[c+1],d[c+2]);f>0&&i.lineTo(u,h)}i.stroke()}})}dispose(){}};var Hg=0,Nd=1,Gg=2;var Sa=1,Wg=2,Mo=3,Xs=0,Xi=1,Mn=2,xs=0,So=1,Dd=2,Fd=3,Ud=4,Zc=5;var gr=100,Xg=101,$g=102,Kc=103,qg=104,Yg=200,ba=201,Zg=202,Kg=203,Od=204,kd=205,Jg=206,jg=207,Qg=208,t0=209,e0=210,i0=211,n0=212,s0=213,r0=214,xc=0,vc=1,yc=2,po=3,Mc=4,Sc=5,bc=6,wc=7,Bd=0,o0=1,a0=2,jn=0,zd=1,Vd=2,Hd=3,Gd=4,Wd=5,Xd=6,$d=7;var qd=300,_r=301,bo=302,Jc=303,jc=304,Ec=1e3,Yn=1001,Tc=1002,pi=1003,l0=1004;var wa=1005;var Pi=1006,Qc=1007;var vs=1008;var dn=1009,Yd=1010,Zd=1011,wo=1012,th=1013,Fn=1014,$i=1015,Un=1016,eh=1017,ih=1018,xr=1020,Kd=35902,Jd=35899,jd=1021,Qd=1022,qi=1023,ms=1026,ys=1027,tf=1028,nh=1029,$s=1030,sh=1031;var rh=1033,Ea=33776,Ta=33777,Aa=33778,Ra=33779,oh=35840,ah=35841,lh=35842,ch=35843,hh=36196,uh=37492,dh=37496,fh=37488,ph=37489,Ca=37490,mh=37491,gh=37808,_h=37809,xh=37810,vh=37811,yh=37812,Mh=37813,Sh=37814,bh=37815,wh=37816,Eh=37817,Th=37818,Ah=37819,Rh=37820,Ch=37821,Ph=36492,Ih=36494,Lh=36495,Nh=36283,Dh=36284,Pa=36285,Fh=36286;var la=2300,Ac=2301,gc=2302,Td=2303,Ad=2400,Rd=2401,Cd=2402;var c0=3200;var ef=0,h0=1,Ms="",ln="srgb",ks="srgb-linear",ca="linear",Ee="srgb";var _c=7680;var u0=519,d0=512,f0=513,p0=514,nf=515,m0=516,g0=517,sf=518,rf=519,_0=35044,Ia=35048;var La="300 es",vn=2e3,ha=2001;function HM(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function GM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ua(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function x0(){let n=ua("canvas");return n.style.display="block",n}var vg={},mo=null;function of(...n){let t="THREE."+n.shift();mo?mo("log",t,...n):console.log(t,...n)}function v0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Yt(...n){n=v0(n);let t="THREE."+n.shift();if(mo)mo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=v0(n);let t="THREE."+n.shift();if(mo)mo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function aa(...n){let t=n.join(" ");t in vg||(vg[t]=!0,Yt(...n))}function y0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var M0={[xc]:xc,[yc]:bc,[Mc]:Mc,[po]:Sc,[vc]:vc,[bc]:yc,[wc]:wc,[Sc]:po},Zn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var rd=Math.PI/180,Rc=180/Math.PI;function Na(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fi[n&255]+Fi[n>>8&255]+Fi[n>>16&255]+Fi[n>>24&255]+"-"+Fi[t&255]+Fi[t>>8&255]+"-"+Fi[t>>16&15|64]+Fi[t>>24&255]+"-"+Fi[e&63|128]+Fi[e>>8&255]+"-"+Fi[e>>16&255]+Fi[e>>24&255]+Fi[i&255]+Fi[i>>8&255]+Fi[i>>16&255]+Fi[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function WM(n,t){return(n%t+t)%t}function od(n,t,e){return(1-e)*n+e*t}function S0(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function af(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function XM(n,t){if(t.constructor===Float32Array)return n;let e=af(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function $M(n,t){if(t.constructor===Float32Array)return n;let e=af(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ge=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Kn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],d=i[s+2],u=i[s+3],h=r[o+0],f=r[o+1],g=r[o+2],_=r[o+3];if(u!==_||l!==h||c!==f||d!==g){let m=l*h+c*f+d*g+u*_;m<0&&(h=-h,f=-f,g=-g,_=-_,m=-m);let p=1-a;if(m<.9995){let y=Math.acos(m),A=Math.sin(y);p=Math.sin(p*y)/A,a=Math.sin(a*y)/A,l=l*p+h*a,c=c*p+f*a,d=d*p+g*a,u=u*p+_*a}else{l=l*p+h*a,c=c*p+f*a,d=d*p+g*a,u=u*p+_*a;let y=1/Math.sqrt(l*l+c*c+d*d+u*u);l*=y,c*=y,d*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=d,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],d=i[s+3],u=r[o],h=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+d*u+l*f-c*h,t[e+1]=l*g+d*h+c*u-a*f,t[e+2]=c*g+d*f+a*h-l*u,t[e+3]=d*g-a*u-l*h-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),d=a(s/2),u=a(r/2),h=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*d*u+c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u-h*f*g;break;case"YXZ":this._x=h*d*u+c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u+h*f*g;break;case"ZXY":this._x=h*d*u-c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u-h*f*g;break;case"ZYX":this._x=h*d*u-c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u+h*f*g;break;case"YZX":this._x=h*d*u+c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u-h*f*g;break;case"XZY":this._x=h*d*u-c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u+h*f*g;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],d=e[6],u=e[10],h=i+a+u;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(d-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(d-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+d)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+d)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,d=e._w;return this._x=i*d+o*a+s*c-r*l,this._y=s*d+o*l+r*a-i*c,this._z=r*d+o*c+i*l-s*a,this._w=o*d-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),d=Math.sin(c);l=Math.sin(l*c)/d,e=Math.sin(e*c)/d,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(yg.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(yg.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),d=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*d,this.y=i+l*d+a*c-r*u,this.z=s+l*u+r*d-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ad.copy(this).projectOnVector(t),this.sub(ad)}reflect(t){return this.sub(ad.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ad=new J,yg=new Kn,Qt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let d=this.elements;return d[0]=t,d[1]=s,d[2]=a,d[3]=e,d[4]=r,d[5]=l,d[6]=i,d[7]=o,d[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],d=i[4],u=i[7],h=i[2],f=i[5],g=i[8],_=s[0],m=s[3],p=s[6],y=s[1],A=s[4],M=s[7],R=s[2],T=s[5],v=s[8];return r[0]=o*_+a*y+l*R,r[3]=o*m+a*A+l*T,r[6]=o*p+a*M+l*v,r[1]=c*_+d*y+u*R,r[4]=c*m+d*A+u*T,r[7]=c*p+d*M+u*v,r[2]=h*_+f*y+g*R,r[5]=h*m+f*A+g*T,r[8]=h*p+f*M+g*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8];return e*o*d-e*a*c-i*r*d+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],u=d*o-a*c,h=a*l-d*r,f=c*r-o*l,g=e*u+i*h+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return t[0]=u*_,t[1]=(s*c-d*i)*_,t[2]=(a*i-s*o)*_,t[3]=h*_,t[4]=(d*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ld.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ld.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ld.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ld=new Qt,Mg=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sg=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function qM(){let n={enabled:!0,workingColorSpace:ks,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ee&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ee&&(s.r=fo(s.r),s.g=fo(s.g),s.b=fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ms?ca:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ks]:{primaries:t,whitePoint:i,transfer:ca,toXYZ:Mg,fromXYZ:Sg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ln},outputColorSpaceConfig:{drawingBufferColorSpace:ln}},[ln]:{primaries:t,whitePoint:i,transfer:Ee,toXYZ:Mg,fromXYZ:Sg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ln}}}),n}var me=qM();function ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function fo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Qr,Cc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Qr===void 0&&(Qr=ua("canvas")),Qr.width=t.width,Qr.height=t.height;let s=Qr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Qr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ua("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ps(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ps(e[i]/255)*255):e[i]=ps(e[i]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},YM=0,go=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:YM++}),this.uuid=Na(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(cd(s[o].image)):r.push(cd(s[o]))}else r=cd(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function cd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Cc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var ZM=0,hd=new J,Ki=class n extends Zn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Yn,s=Yn,r=Pi,o=vs,a=qi,l=dn,c=n.DEFAULT_ANISOTROPY,d=Ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ZM++}),this.uuid=Na(),this.name="",this.source=new go(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ge(0,0),this.repeat=new ge(1,1),this.center=new ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hd).x}get height(){return this.source.getSize(hd).y}get depth(){return this.source.getSize(hd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==qd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ec:t.x=t.x-Math.floor(t.x);break;case Yn:t.x=t.x<0?0:1;break;case Tc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ec:t.y=t.y-Math.floor(t.y);break;case Yn:t.y=t.y<0?0:1;break;case Tc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Ki.DEFAULT_IMAGE=null;Ki.DEFAULT_MAPPING=qd;Ki.DEFAULT_ANISOTROPY=1;var Je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],d=l[4],u=l[8],h=l[1],f=l[5],g=l[9],_=l[2],m=l[6],p=l[10];if(Math.abs(d-h)<.01&&Math.abs(u-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(d+h)<.1&&Math.abs(u+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,M=(f+1)/2,R=(p+1)/2,T=(d+h)/4,v=(u+_)/4,E=(g+m)/4;return A>M&&A>R?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=T/i,r=v/i):M>R?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=T/s,r=E/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=v/r,s=E/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(u-_)*(u-_)+(h-d)*(h-d));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(u-_)/y,this.z=(h-d)/y,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Pc=class extends Zn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Pi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Je(0,0,t,e),this.scissorTest=!1,this.viewport=new Je(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Ki({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Pi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new go(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wi=class extends Pc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},da=class extends Ki{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=Yn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ic=class extends Ki{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=Yn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Oe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,d,u,h,f,g,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,d,u,h,f,g,_,m)}set(t,e,i,s,r,o,a,l,c,d,u,h,f,g,_,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=d,p[10]=u,p[14]=h,p[3]=f,p[7]=g,p[11]=_,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/to.setFromMatrixColumn(t,0).length(),r=1/to.setFromMatrixColumn(t,1).length(),o=1/to.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),d=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let h=o*d,f=o*u,g=a*d,_=a*u;e[0]=l*d,e[4]=-l*u,e[8]=c,e[1]=f+g*c,e[5]=h-_*c,e[9]=-a*l,e[2]=_-h*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*d,f=l*u,g=c*d,_=c*u;e[0]=h+_*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*d,e[9]=-a,e[2]=f*a-g,e[6]=_+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*d,f=l*u,g=c*d,_=c*u;e[0]=h-_*a,e[4]=-o*u,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*d,e[9]=_-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*d,f=o*u,g=a*d,_=a*u;e[0]=l*d,e[4]=g*c-f,e[8]=h*c+_,e[1]=l*u,e[5]=_*c+h,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,f=o*c,g=a*l,_=a*c;e[0]=l*d,e[4]=_-h*u,e[8]=g*u+f,e[1]=u,e[5]=o*d,e[9]=-a*d,e[2]=-c*d,e[6]=f*u+g,e[10]=h-_*u}else if(t.order==="XZY"){let h=o*l,f=o*c,g=a*l,_=a*c;e[0]=l*d,e[4]=-u,e[8]=c*d,e[1]=h*u+_,e[5]=o*d,e[9]=f*u-g,e[2]=g*u-f,e[6]=a*d,e[10]=_*u+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(KM,t,JM)}lookAt(t,e,i){let s=this.elements;return on.subVectors(t,e),on.lengthSq()===0&&(on.z=1),on.normalize(),Ls.crossVectors(i,on),Ls.lengthSq()===0&&(Math.abs(i.z)===1?on.x+=1e-4:on.z+=1e-4,on.normalize(),Ls.crossVectors(i,on)),Ls.normalize(),Yl.crossVectors(on,Ls),s[0]=Ls.x,s[4]=Yl.x,s[8]=on.x,s[1]=Ls.y,s[5]=Yl.y,s[9]=on.y,s[2]=Ls.z,s[6]=Yl.z,s[10]=on.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],d=i[1],u=i[5],h=i[9],f=i[13],g=i[2],_=i[6],m=i[10],p=i[14],y=i[3],A=i[7],M=i[11],R=i[15],T=s[0],v=s[4],E=s[8],k=s[12],D=s[1],L=s[5],G=s[9],W=s[13],N=s[2],V=s[6],X=s[10],O=s[14],lt=s[3],Z=s[7],Q=s[11],st=s[15];return r[0]=o*T+a*D+l*N+c*lt,r[4]=o*v+a*L+l*V+c*Z,r[8]=o*E+a*G+l*X+c*Q,r[12]=o*k+a*W+l*O+c*st,r[1]=d*T+u*D+h*N+f*lt,r[5]=d*v+u*L+h*V+f*Z,r[9]=d*E+u*G+h*X+f*Q,r[13]=d*k+u*W+h*O+f*st,r[2]=g*T+_*D+m*N+p*lt,r[6]=g*v+_*L+m*V+p*Z,r[10]=g*E+_*G+m*X+p*Q,r[14]=g*k+_*W+m*O+p*st,r[3]=y*T+A*D+M*N+R*lt,r[7]=y*v+A*L+M*V+R*Z,r[11]=y*E+A*G+M*X+R*Q,r[15]=y*k+A*W+M*O+R*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],d=t[2],u=t[6],h=t[10],f=t[14],g=t[3],_=t[7],m=t[11],p=t[15],y=l*f-c*h,A=a*f-c*u,M=a*h-l*u,R=o*f-c*d,T=o*h-l*d,v=o*u-a*d;return e*(_*y-m*A+p*M)-i*(g*y-m*R+p*T)+s*(g*A-_*R+p*v)-r*(g*M-_*T+m*v)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],d=t[10];return e*(o*d-a*c)-i*(r*d-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],u=t[9],h=t[10],f=t[11],g=t[12],_=t[13],m=t[14],p=t[15],y=e*a-i*o,A=e*l-s*o,M=e*c-r*o,R=i*l-s*a,T=i*c-r*a,v=s*c-r*l,E=d*_-u*g,k=d*m-h*g,D=d*p-f*g,L=u*m-h*_,G=u*p-f*_,W=h*p-f*m,N=y*W-A*G+M*L+R*D-T*k+v*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*W-l*G+c*L)*V,t[1]=(s*G-i*W-r*L)*V,t[2]=(_*v-m*T+p*R)*V,t[3]=(h*T-u*v-f*R)*V,t[4]=(l*D-o*W-c*k)*V,t[5]=(e*W-s*D+r*k)*V,t[6]=(m*M-g*v-p*A)*V,t[7]=(d*v-h*M+f*A)*V,t[8]=(o*G-a*D+c*E)*V,t[9]=(i*D-e*G-r*E)*V,t[10]=(g*T-_*M+p*y)*V,t[11]=(u*M-d*T-f*y)*V,t[12]=(a*k-o*L-l*E)*V,t[13]=(e*L-i*k+s*E)*V,t[14]=(_*A-g*R-m*y)*V,t[15]=(d*R-u*A+h*y)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,d=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,d*a+i,d*l-s*o,0,c*l-s*a,d*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,d=o+o,u=a+a,h=r*c,f=r*d,g=r*u,_=o*d,m=o*u,p=a*u,y=l*c,A=l*d,M=l*u,R=i.x,T=i.y,v=i.z;return s[0]=(1-(_+p))*R,s[1]=(f+M)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(f-M)*T,s[5]=(1-(h+p))*T,s[6]=(m+y)*T,s[7]=0,s[8]=(g+A)*v,s[9]=(m-y)*v,s[10]=(1-(h+_))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=to.set(s[0],s[1],s[2]).length(),a=to.set(s[4],s[5],s[6]).length(),l=to.set(s[8],s[9],s[10]).length();r<0&&(o=-o),In.copy(this);let c=1/o,d=1/a,u=1/l;return In.elements[0]*=c,In.elements[1]*=c,In.elements[2]*=c,In.elements[4]*=d,In.elements[5]*=d,In.elements[6]*=d,In.elements[8]*=u,In.elements[9]*=u,In.elements[10]*=u,e.setFromRotationMatrix(In),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=vn,l=!1){let c=this.elements,d=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===vn)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ha)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=vn,l=!1){let c=this.elements,d=2/(e-t),u=2/(i-s),h=-(e+t)/(e-t),f=-(i+s)/(i-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===vn)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===ha)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},to=new J,In=new Oe,KM=new J(0,0,0),JM=new J(1,1,1),Ls=new J,Yl=new J,on=new J,bg=new Oe,wg=new Kn,Bs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],d=s[9],u=s[2],h=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-d,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-d,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-d,f),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return bg.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bg,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return wg.setFromEuler(this),this.setFromQuaternion(wg,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Bs.DEFAULT_ORDER="XYZ";var fa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},jM=0,Eg=new J,eo=new Kn,cs=new Oe,Zl=new J,na=new J,QM=new J,tS=new Kn,Tg=new J(1,0,0),Ag=new J(0,1,0),Rg=new J(0,0,1),Cg={type:"added"},eS={type:"removed"},io={type:"childadded",child:null},ud={type:"childremoved",child:null},hn=class n extends Zn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:jM++}),this.uuid=Na(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new J,e=new Bs,i=new Kn,s=new J(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Oe},normalMatrix:{value:new Qt}}),this.matrix=new Oe,this.matrixWorld=new Oe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return eo.setFromAxisAngle(t,e),this.quaternion.multiply(eo),this}rotateOnWorldAxis(t,e){return eo.setFromAxisAngle(t,e),this.quaternion.premultiply(eo),this}rotateX(t){return this.rotateOnAxis(Tg,t)}rotateY(t){return this.rotateOnAxis(Ag,t)}rotateZ(t){return this.rotateOnAxis(Rg,t)}translateOnAxis(t,e){return Eg.copy(t).applyQuaternion(this.quaternion),this.position.add(Eg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Tg,t)}translateY(t){return this.translateOnAxis(Ag,t)}translateZ(t){return this.translateOnAxis(Rg,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Zl.copy(t):Zl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(na,Zl,this.up):cs.lookAt(Zl,na,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),eo.setFromRotationMatrix(cs),this.quaternion.premultiply(eo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cg),io.child=t,this.dispatchEvent(io),io.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(eS),ud.child=t,this.dispatchEvent(ud),ud.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),cs.multiply(t.parent.matrixWorld)),t.applyMatrix4(cs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cg),io.child=t,this.dispatchEvent(io),io.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,QM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,tS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,d=l.length;c<d;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),d=o(t.images),u=o(t.shapes),h=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),d.length>0&&(i.images=d),u.length>0&&(i.shapes=u),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let d=a[c];delete d.metadata,l.push(d)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};hn.DEFAULT_UP=new J(0,1,0);hn.DEFAULT_MATRIX_AUTO_UPDATE=!0;hn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var hr=class extends hn{constructor(){super(),this.isGroup=!0,this.type="Group"}},iS={type:"move"},_o=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new hr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new hr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new hr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),p=this._getHandJoint(c,_);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let d=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],h=d.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&h>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(iS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new hr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},b0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ns={h:0,s:0,l:0},Kl={h:0,s:0,l:0};function dd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var _e=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ln){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,me.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=me.workingColorSpace){return this.r=t,this.g=e,this.b=i,me.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=me.workingColorSpace){if(t=WM(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=dd(o,r,t+1/3),this.g=dd(o,r,t),this.b=dd(o,r,t-1/3)}return me.colorSpaceToWorking(this,s),this}setStyle(t,e=ln){function i(r){r!==void 0&&parseFloat(r)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ln){let i=b0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ps(t.r),this.g=ps(t.g),this.b=ps(t.b),this}copyLinearToSRGB(t){return this.r=fo(t.r),this.g=fo(t.g),this.b=fo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ln){return me.workingToColorSpace(Ui.copy(this),t),Math.round(xe(Ui.r*255,0,255))*65536+Math.round(xe(Ui.g*255,0,255))*256+Math.round(xe(Ui.b*255,0,255))}getHexString(t=ln){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=me.workingColorSpace){me.workingToColorSpace(Ui.copy(this),e);let i=Ui.r,s=Ui.g,r=Ui.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,d=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=d<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=d,t}getRGB(t,e=me.workingColorSpace){return me.workingToColorSpace(Ui.copy(this),e),t.r=Ui.r,t.g=Ui.g,t.b=Ui.b,t}getStyle(t=ln){me.workingToColorSpace(Ui.copy(this),t);let e=Ui.r,i=Ui.g,s=Ui.b;return t!==ln?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ns),this.setHSL(Ns.h+t,Ns.s+e,Ns.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ns),t.getHSL(Kl);let i=od(Ns.h,Kl.h,e),s=od(Ns.s,Kl.s,e),r=od(Ns.l,Kl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ui=new _e;_e.NAMES=b0;var ur=class extends hn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Bs,this.environmentIntensity=1,this.environmentRotation=new Bs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ln=new J,hs=new J,fd=new J,us=new J,no=new J,so=new J,Pg=new J,pd=new J,md=new J,gd=new J,_d=new Je,xd=new Je,vd=new Je,Os=class n{constructor(t=new J,e=new J,i=new J){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ln.subVectors(t,e),s.cross(Ln);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ln.subVectors(s,e),hs.subVectors(i,e),fd.subVectors(t,e);let o=Ln.dot(Ln),a=Ln.dot(hs),l=Ln.dot(fd),c=hs.dot(hs),d=hs.dot(fd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let h=1/u,f=(c*l-a*d)*h,g=(o*d-a*l)*h;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,us.x),l.addScaledVector(o,us.y),l.addScaledVector(a,us.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return _d.setScalar(0),xd.setScalar(0),vd.setScalar(0),_d.fromBufferAttribute(t,e),xd.fromBufferAttribute(t,i),vd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(_d,r.x),o.addScaledVector(xd,r.y),o.addScaledVector(vd,r.z),o}static isFrontFacing(t,e,i,s){return Ln.subVectors(i,e),hs.subVectors(t,e),Ln.cross(hs).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ln.subVectors(this.c,this.b),hs.subVectors(this.a,this.b),Ln.cross(hs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;no.subVectors(s,i),so.subVectors(r,i),pd.subVectors(t,i);let l=no.dot(pd),c=so.dot(pd);if(l<=0&&c<=0)return e.copy(i);md.subVectors(t,s);let d=no.dot(md),u=so.dot(md);if(d>=0&&u<=d)return e.copy(s);let h=l*u-d*c;if(h<=0&&l>=0&&d<=0&&l-d>0)return o=l/(l-d),e.copy(i).addScaledVector(no,o);gd.subVectors(t,r);let f=no.dot(gd),g=so.dot(gd);if(g>=0&&f<=g)return e.copy(r);let _=f*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(so,a);let m=d*g-f*u;if(m<=0&&u-d>=0&&f-g>=0)return Pg.subVectors(r,s),a=(u-d)/(u-d+(f-g)),e.copy(s).addScaledVector(Pg,a);let p=1/(m+_+h);return o=_*p,a=h*p,e.copy(i).addScaledVector(no,o).addScaledVector(so,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zs=class{constructor(t=new J(1/0,1/0,1/0),e=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Nn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Nn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Nn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Nn):Nn.fromBufferAttribute(r,o),Nn.applyMatrix4(t.matrixWorld),this.expandByPoint(Nn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Jl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Jl.copy(i.boundingBox)),Jl.applyMatrix4(t.matrixWorld),this.union(Jl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Nn),Nn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(sa),jl.subVectors(this.max,sa),ro.subVectors(t.a,sa),oo.subVectors(t.b,sa),ao.subVectors(t.c,sa),Ds.subVectors(oo,ro),Fs.subVectors(ao,oo),or.subVectors(ro,ao);let e=[0,-Ds.z,Ds.y,0,-Fs.z,Fs.y,0,-or.z,or.y,Ds.z,0,-Ds.x,Fs.z,0,-Fs.x,or.z,0,-or.x,-Ds.y,Ds.x,0,-Fs.y,Fs.x,0,-or.y,or.x,0];return!yd(e,ro,oo,ao,jl)||(e=[1,0,0,0,1,0,0,0,1],!yd(e,ro,oo,ao,jl))?!1:(Ql.crossVectors(Ds,Fs),e=[Ql.x,Ql.y,Ql.z],yd(e,ro,oo,ao,jl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Nn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Nn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ds),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ds=[new J,new J,new J,new J,new J,new J,new J,new J],Nn=new J,Jl=new zs,ro=new J,oo=new J,ao=new J,Ds=new J,Fs=new J,or=new J,sa=new J,jl=new J,Ql=new J,ar=new J;function yd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ar.fromArray(n,r);let a=s.x*Math.abs(ar.x)+s.y*Math.abs(ar.y)+s.z*Math.abs(ar.z),l=t.dot(ar),c=e.dot(ar),d=i.dot(ar);if(Math.max(-Math.max(l,c,d),Math.min(l,c,d))>a)return!1}return!0}var fi=new J,tc=new ge,nS=0,ri=class extends Zn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:nS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=_0,this.updateRanges=[],this.gpuType=$i,this.version=0,this._normalizationScale=t!==void 0?af(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)tc.fromBufferAttribute(this,e),tc.applyMatrix3(t),this.setXY(e,tc.x,tc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyMatrix3(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyMatrix4(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.applyNormalMatrix(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)fi.fromBufferAttribute(this,e),fi.transformDirection(t),this.setXYZ(e,fi.x,fi.y,fi.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):XM(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):$M(t,this.array)}};var pa=class extends ri{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ma=class extends ri{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var yn=class extends ri{constructor(t,e,i){super(new Float32Array(t),e,i)}},sS=new zs,ra=new J,Md=new J,dr=class{constructor(t=new J,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):sS.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ra.subVectors(t,this.center);let e=ra.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ra,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Md.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ra.copy(t.center).add(Md)),this.expandByPoint(ra.copy(t.center).sub(Md))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},rS=0,xn=new Oe,Sd=new hn,lo=new J,an=new zs,oa=new zs,Ci=new J,mi=class n extends Zn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:rS++}),this.uuid=Na(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(HM(t)?ma:pa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Qt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return xn.makeRotationFromQuaternion(t),this.applyMatrix4(xn),this}rotateX(t){return xn.makeRotationX(t),this.applyMatrix4(xn),this}rotateY(t){return xn.makeRotationY(t),this.applyMatrix4(xn),this}rotateZ(t){return xn.makeRotationZ(t),this.applyMatrix4(xn),this}translate(t,e,i){return xn.makeTranslation(t,e,i),this.applyMatrix4(xn),this}scale(t,e,i){return xn.makeScale(t,e,i),this.applyMatrix4(xn),this}lookAt(t){return Sd.lookAt(t),Sd.updateMatrix(),this.applyMatrix4(Sd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(lo).negate(),this.translate(lo.x,lo.y,lo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new yn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];an.setFromBufferAttribute(r),this.morphTargetsRelative?(Ci.addVectors(this.boundingBox.min,an.min),this.boundingBox.expandByPoint(Ci),Ci.addVectors(this.boundingBox.max,an.max),this.boundingBox.expandByPoint(Ci)):(this.boundingBox.expandByPoint(an.min),this.boundingBox.expandByPoint(an.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new dr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new J,1/0);return}if(t){let i=this.boundingSphere.center;if(an.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];oa.setFromBufferAttribute(a),this.morphTargetsRelative?(Ci.addVectors(an.min,oa.min),an.expandByPoint(Ci),Ci.addVectors(an.max,oa.max),an.expandByPoint(Ci)):(an.expandByPoint(oa.min),an.expandByPoint(oa.max))}an.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ci.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ci));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,d=a.count;c<d;c++)Ci.fromBufferAttribute(a,c),l&&(lo.fromBufferAttribute(t,c),Ci.add(lo)),s=Math.max(s,i.distanceToSquared(Ci))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ri(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new J,l[k]=new J;let d=new J,u=new J,h=new J,f=new ge,g=new ge,_=new ge,m=new J,p=new J;function y(k,D,L){c[k]=c[D]=c[L]=1,d.fromBufferAttribute(i,k),u.fromBufferAttribute(i,D),h.fromBufferAttribute(i,L),f.fromBufferAttribute(r,k),g.fromBufferAttribute(r,D),_.fromBufferAttribute(r,L),u.sub(d),h.sub(d),g.sub(f),_.sub(f);let G=1/(g.x*_.y-_.x*g.y);isFinite(G)&&(m.copy(u).multiplyScalar(_.y).addScaledVector(h,-g.y).multiplyScalar(G),p.copy(h).multiplyScalar(g.x).addScaledVector(u,-_.x).multiplyScalar(G),a[k].add(m),a[D].add(m),a[L].add(m),l[k].add(p),l[D].add(p),l[L].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let k=0,D=A.length;k<D;++k){let L=A[k],G=L.start,W=L.count;for(let N=G,V=G+W;N<V;N+=3)y(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let M=new J,R=new J,T=new J,v=new J;function E(k){T.fromBufferAttribute(s,k),v.copy(T);let D=a[k];M.copy(D),M.sub(T.multiplyScalar(T.dot(D))).normalize(),R.crossVectors(v,D);let G=R.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,G)}for(let k=0,D=i.count;k<D;++k)c[k]&&E(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ri(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new J,r=new J,o=new J,a=new J,l=new J,c=new J,d=new J,u=new J;if(t)for(let h=0,f=t.count;h<f;h+=3){let g=t.getX(h+0),_=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(d),l.add(d),c.add(d),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=e.count;h<f;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),i.setXYZ(h+0,d.x,d.y,d.z),i.setXYZ(h+1,d.x,d.y,d.z),i.setXYZ(h+2,d.x,d.y,d.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ci.fromBufferAttribute(t,e),Ci.normalize(),t.setXYZ(e,Ci.x,Ci.y,Ci.z)}toNonIndexed(){function t(a,l){let c=a.array,d=a.itemSize,u=a.normalized,h=new c.constructor(l.length*d),f=0,g=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*d;for(let p=0;p<d;p++)h[g++]=c[f++]}return new ri(h,d,u)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let d=0,u=c.length;d<u;d++){let h=c[d],f=t(h,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],d=[];for(let u=0,h=c.length;u<h;u++){let f=c[u];d.push(f.toJSON(t.data))}d.length>0&&(s[l]=d,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let d=s[c];this.setAttribute(c,d.clone(e))}let r=t.morphAttributes;for(let c in r){let d=[],u=r[c];for(let h=0,f=u.length;h<f;h++)d.push(u[h].clone(e));this.morphAttributes[c]=d}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,d=o.length;c<d;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var bd=new J,oS=new J,aS=new Qt,Dn=class{constructor(t=new J(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=bd.subVectors(i,e).cross(oS.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(bd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||aS.getNormalMatrix(t),s=this.coplanarPoint(bd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},lS=0,Vs=class extends Zn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:lS++}),this.uuid=Na(),this.name="",this.type="Material",this.blending=So,this.side=Xs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Od,this.blendDst=kd,this.blendEquation=gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new _e(0,0,0),this.blendAlpha=0,this.depthFunc=po,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=u0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=_c,this.stencilZFail=_c,this.stencilZPass=_c,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new _e().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Dn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ge().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ge().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var fs=new J,wd=new J,ec=new J,ic=new J,ga=class{constructor(t=new J,e=new J(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,fs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=fs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(fs.copy(this.origin).addScaledVector(this.direction,e),fs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){wd.copy(t).add(e).multiplyScalar(.5),ec.copy(e).sub(t).normalize(),ic.copy(this.origin).sub(wd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ec),a=ic.dot(this.direction),l=-ic.dot(ec),c=ic.lengthSq(),d=Math.abs(1-o*o),u,h,f,g;if(d>0)if(u=o*l-a,h=o*a-l,g=r*d,u>=0)if(h>=-g)if(h<=g){let _=1/d;u*=_,h*=_,f=u*(u+o*h+2*a)+h*(o*u+h+2*l)+c}else h=r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h=-r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h<=-g?(u=Math.max(0,-(-o*r+a)),h=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c):h<=g?(u=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(u=Math.max(0,-(o*r+a)),h=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c);else h=o>0?-r:r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(wd).addScaledVector(ec,h),f}intersectSphere(t,e){if(t.radius<0)return null;fs.subVectors(t.center,this.origin);let i=fs.dot(this.direction),s=fs.dot(fs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,d=1/this.direction.y,u=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),d>=0?(r=(t.min.y-h.y)*d,o=(t.max.y-h.y)*d):(r=(t.max.y-h.y)*d,o=(t.min.y-h.y)*d),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-h.z)*u,l=(t.max.z-h.z)*u):(a=(t.max.z-h.z)*u,l=(t.min.z-h.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,fs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,d=a.z,u=t.x-o.x,h=t.y-o.y,f=t.z-o.z,g=e.x-o.x,_=e.y-o.y,m=e.z-o.z,p=i.x-o.x,y=i.y-o.y,A=i.z-o.z,M=Math.abs(l),R=Math.abs(c),T=Math.abs(d),v,E,k,D,L,G,W,N,V,X,O,lt;if(M>=R&&M>=T?(k=l,G=u,V=g,lt=p,l>=0?(v=c,E=d,D=h,L=f,W=_,N=m,X=y,O=A):(v=d,E=c,D=f,L=h,W=m,N=_,X=A,O=y)):R>=T?(k=c,G=h,V=_,lt=y,c>=0?(v=d,E=l,D=f,L=u,W=m,N=g,X=A,O=p):(v=l,E=d,D=u,L=f,W=g,N=m,X=p,O=A)):(k=d,G=f,V=m,lt=A,d>=0?(v=l,E=c,D=u,L=h,W=g,N=_,X=p,O=y):(v=c,E=l,D=h,L=u,W=_,N=g,X=y,O=p)),k===0)return null;let Z=v/k,Q=E/k,st=1/k,dt=D-Z*G,ut=L-Q*G,tt=W-Z*V,mt=N-Q*V,xt=X-Z*lt,At=O-Q*lt,St=xt*mt-At*tt,Gt=dt*At-ut*xt,ie=tt*ut-mt*dt;if(s){if(St<0||Gt<0||ie<0)return null}else if((St<0||Gt<0||ie<0)&&(St>0||Gt>0||ie>0))return null;let Vt=St+Gt+ie;if(Vt===0)return null;let ce=st*(St*G+Gt*V+ie*lt);return(Vt>0?ce<0:ce>0)?null:this.at(ce/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Lc=class extends Vs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new _e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bs,this.combine=Bd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Ig=new Oe,lr=new ga,nc=new dr,Lg=new J,sc=new J,rc=new J,oc=new J,Ed=new J,ac=new J,Ng=new J,lc=new J,Mi=class extends hn{constructor(t=new mi,e=new Lc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){ac.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let d=a[l],u=r[l];d!==0&&(Ed.fromBufferAttribute(u,t),o?ac.addScaledVector(Ed,d):ac.addScaledVector(Ed.sub(e),d))}e.add(ac)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),nc.copy(i.boundingSphere),nc.applyMatrix4(r),lr.copy(t.ray).recast(t.near),!(nc.containsPoint(lr.origin)===!1&&(lr.intersectSphere(nc,Lg)===null||lr.origin.distanceToSquared(Lg)>(t.far-t.near)**2))&&(Ig.copy(r).invert(),lr.copy(t.ray).applyMatrix4(Ig),!(i.boundingBox!==null&&lr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,lr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,d=r.attributes.uv1,u=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=h.length;g<_;g++){let m=h[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,R=A;M<R;M+=3){let T=a.getX(M),v=a.getX(M+1),E=a.getX(M+2);s=cc(this,p,t,i,c,d,u,T,v,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=g,p=_;m<p;m+=3){let y=a.getX(m),A=a.getX(m+1),M=a.getX(m+2);s=cc(this,o,t,i,c,d,u,y,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=h.length;g<_;g++){let m=h[g],p=o[m.materialIndex],y=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let M=y,R=A;M<R;M+=3){let T=M,v=M+1,E=M+2;s=cc(this,p,t,i,c,d,u,T,v,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=g,p=_;m<p;m+=3){let y=m,A=m+1,M=m+2;s=cc(this,o,t,i,c,d,u,y,A,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function cS(n,t,e,i,s,r,o,a){let l;if(t.side===Xi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Xs,a),l===null)return null;lc.copy(a),lc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(lc);return c<e.near||c>e.far?null:{distance:c,point:lc.clone(),object:n}}function cc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,sc),n.getVertexPosition(l,rc),n.getVertexPosition(c,oc);let d=cS(n,t,e,i,sc,rc,oc,Ng);if(d){let u=new J;Os.getBarycoord(Ng,sc,rc,oc,u),s&&(d.uv=Os.getInterpolatedAttribute(s,a,l,c,u,new ge)),r&&(d.uv1=Os.getInterpolatedAttribute(r,a,l,c,u,new ge)),o&&(d.normal=Os.getInterpolatedAttribute(o,a,l,c,u,new J),d.normal.dot(i.direction)>0&&d.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new J,materialIndex:0};Os.getNormal(sc,rc,oc,h.normal),d.face=h,d.barycoord=u}return d}var gs=class extends Ki{constructor(t=null,e=1,i=1,s,r,o,a,l,c=pi,d=pi,u,h){super(null,o,a,l,c,d,s,r,u,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var cr=new dr,hS=new ge(.5,.5),hc=new J,fr=class{constructor(t=new Dn,e=new Dn,i=new Dn,s=new Dn,r=new Dn,o=new Dn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=vn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],d=r[4],u=r[5],h=r[6],f=r[7],g=r[8],_=r[9],m=r[10],p=r[11],y=r[12],A=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,f-d,p-g,R-y).normalize(),s[1].setComponents(c+o,f+d,p+g,R+y).normalize(),s[2].setComponents(c+a,f+u,p+_,R+A).normalize(),s[3].setComponents(c-a,f-u,p-_,R-A).normalize(),i)s[4].setComponents(l,h,m,M).normalize(),s[5].setComponents(c-l,f-h,p-m,R-M).normalize();else if(s[4].setComponents(c-l,f-h,p-m,R-M).normalize(),e===vn)s[5].setComponents(c+l,f+h,p+m,R+M).normalize();else if(e===ha)s[5].setComponents(l,h,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),cr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),cr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(cr)}intersectsSprite(t){cr.center.set(0,0,0);let e=hS.distanceTo(t.center);return cr.radius=.7071067811865476+e,cr.applyMatrix4(t.matrixWorld),this.intersectsSphere(cr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(hc.x=s.normal.x>0?t.max.x:t.min.x,hc.y=s.normal.y>0?t.max.y:t.min.y,hc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(hc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Dg=new Oe,Nc=class n{constructor(){this.coordinateSystem=vn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Dg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new fr),i[s].setFromProjectionMatrix(Dg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new fr),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Dc=class extends Vs{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new _e(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Fg=new Oe,Pd=new ga,uc=new dr,dc=new J,pr=class extends hn{constructor(t=new mi,e=new Dc){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),uc.copy(i.boundingSphere),uc.applyMatrix4(s),uc.radius+=r,t.ray.intersectsSphere(uc)===!1)return;Fg.copy(s).invert(),Pd.copy(t.ray).applyMatrix4(Fg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,u=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=h,_=f;g<_;g++){let m=c.getX(g);dc.fromBufferAttribute(u,m),Ug(dc,m,l,s,t,e,this)}}else{let h=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let g=h,_=f;g<_;g++)dc.fromBufferAttribute(u,g),Ug(dc,g,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ug(n,t,e,i,s,r,o){let a=Pd.distanceSqToPoint(n);if(a<e){let l=new J;Pd.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var _a=class extends Ki{constructor(t=[],e=_r,i,s,r,o,a,l,c,d){super(t,e,i,s,r,o,a,l,c,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _s=class extends Ki{constructor(t,e,i=Fn,s,r,o,a=pi,l=pi,c,d=ms,u=1){if(d!==ms&&d!==ys)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:u};super(h,s,r,o,a,l,d,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new go(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},xa=class extends _s{constructor(t,e=Fn,i=_r,s,r,o=pi,a=pi,l,c=ms){let d={width:t,height:t,depth:1},u=[d,d,d,d,d,d];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},va=class extends Ki{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},xo=class n extends mi{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],d=[],u=[],h=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new yn(c,3)),this.setAttribute("normal",new yn(d,3)),this.setAttribute("uv",new yn(u,2));function g(_,m,p,y,A,M,R,T,v,E,k){let D=M/v,L=R/E,G=M/2,W=R/2,N=T/2,V=v+1,X=E+1,O=0,lt=0,Z=new J;for(let Q=0;Q<X;Q++){let st=Q*L-W;for(let dt=0;dt<V;dt++){let ut=dt*D-G;Z[_]=ut*y,Z[m]=st*A,Z[p]=N,c.push(Z.x,Z.y,Z.z),Z[_]=0,Z[m]=0,Z[p]=T>0?1:-1,d.push(Z.x,Z.y,Z.z),u.push(dt/v),u.push(1-Q/E),O+=1}}for(let Q=0;Q<E;Q++)for(let st=0;st<v;st++){let dt=h+st+V*Q,ut=h+st+V*(Q+1),tt=h+(st+1)+V*(Q+1),mt=h+(st+1)+V*Q;l.push(dt,ut,mt),l.push(ut,tt,mt),lt+=6}a.addGroup(f,lt,k),f+=lt,h+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ya=class n extends mi{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,d=l+1,u=t/a,h=e/l,f=[],g=[],_=[],m=[];for(let p=0;p<d;p++){let y=p*h-o;for(let A=0;A<c;A++){let M=A*u-r;g.push(M,-y,0),_.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let A=y+c*p,M=y+c*(p+1),R=y+1+c*(p+1),T=y+1+c*p;f.push(A,M,T),f.push(M,R,T)}this.setIndex(f),this.setAttribute("position",new yn(g,3)),this.setAttribute("normal",new yn(_,3)),this.setAttribute("uv",new yn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function vr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Og(s))s.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Og(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Oi(n){let t={};for(let e=0;e<n.length;e++){let i=vr(n[e]);for(let s in i)t[s]=i[s]}return t}function Og(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function uS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function lf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:me.workingColorSpace}var w0={clone:vr,merge:Oi},dS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,fS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Jn=class extends Vs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=dS,this.fragmentShader=fS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=vr(t.uniforms),this.uniformsGroups=uS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new _e().setHex(s.value);break;case"v2":this.uniforms[i].value=new ge().fromArray(s.value);break;case"v3":this.uniforms[i].value=new J().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Je().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Oe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},vo=class extends Jn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Fc=class extends Vs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=c0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Uc=class extends Vs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function co(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function fc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Hs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Oc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ad,endingEnd:Ad}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Rd:r=t,a=2*e-i;break;case Cd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Rd:o=t,l=2*i-e;break;case Cd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,d=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*d,this._offsetNext=o*d}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this._offsetPrev,u=this._offsetNext,h=this._weightPrev,f=this._weightNext,g=(i-e)/(s-e),_=g*g,m=_*g,p=-h*m+2*h*_-h*g,y=(1+h)*m+(-1.5-2*h)*_+(-.5+h)*g+1,A=(-1-f)*m+(1.5+f)*_+.5*g,M=f*m-f*_;for(let R=0;R!==a;++R)r[R]=p*o[d+R]+y*o[c+R]+A*o[l+R]+M*o[u+R];return r}},kc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=(i-e)/(s-e),u=1-d;for(let h=0;h!==a;++h)r[h]=o[c+h]*u+o[l+h]*d;return r}},Bc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},zc=class extends Hs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this.inTangents,u=this.outTangents;if(!d||!u){let g=(i-e)/(s-e),_=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*g;return r}let h=a*2,f=t-1;for(let g=0;g!==a;++g){let _=o[c+g],m=o[l+g],p=f*h+g*2,y=u[p],A=u[p+1],M=t*h+g*2,R=d[M],T=d[M+1],v=mS(i,e,y,R,s);r[g]=E0(v,_,A,T,m)}return r}};function E0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function pS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function mS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=E0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=pS(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var un=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=co(e,this.TimeBufferType),this.values=co(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:co(t.times,Array),values:co(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),fc(t.settings)&&(i.settings={inTangents:co(t.settings.inTangents,Array),outTangents:co(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Bc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new kc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Oc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new zc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case la:e=this.InterpolantFactoryMethodDiscrete;break;case Ac:e=this.InterpolantFactoryMethodLinear;break;case gc:e=this.InterpolantFactoryMethodSmooth;break;case Td:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Yt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return la;case this.InterpolantFactoryMethodLinear:return Ac;case this.InterpolantFactoryMethodSmooth:return gc;case this.InterpolantFactoryMethodBezier:return Td}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;fc(this.settings)&&(kg(this.settings.inTangents,t),kg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;fc(this.settings)&&(Bg(this.settings.inTangents,t),Bg(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&GM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===gc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],d=t[a+1];if(c!==d&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,h=u-i,f=u+i;for(let g=0;g!==i;++g){let _=e[u+g];if(_!==e[h+g]||_!==e[f+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,h=o*i;for(let f=0;f!==i;++f)e[h+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,fc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function kg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Bg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}un.prototype.ValueTypeName="";un.prototype.TimeBufferType=Float32Array;un.prototype.ValueBufferType=Float32Array;un.prototype.DefaultInterpolation=Ac;var Gs=class extends un{constructor(t,e,i){super(t,e,i)}};Gs.prototype.ValueTypeName="bool";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=la;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Vc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};Vc.prototype.ValueTypeName="color";var Hc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};Hc.prototype.ValueTypeName="number";var Gc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let d=c+a;c!==d;c+=4)Kn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ma=class extends un{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Gc(this.times,this.values,this.getValueSize(),t)}};Ma.prototype.ValueTypeName="quaternion";Ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Ws=class extends un{constructor(t,e,i){super(t,e,i)}};Ws.prototype.ValueTypeName="string";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=la;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Wc=class extends un{constructor(t,e,i,s){super(t,e,i,s)}};Wc.prototype.ValueTypeName="vector";var Xc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(d){a++,r===!1&&s.onStart!==void 0&&s.onStart(d,o,a),r=!0},this.itemEnd=function(d){o++,s.onProgress!==void 0&&s.onProgress(d,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(d){s.onError!==void 0&&s.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),l?l(d):d},this.setURLModifier=function(d){return l=d,this},this.addHandler=function(d,u){return c.push(d,u),this},this.removeHandler=function(d){let u=c.indexOf(d);return u!==-1&&c.splice(u,2),this},this.getHandler=function(d){for(let u=0,h=c.length;u<h;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(d))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},T0=new Xc,$c=class{constructor(t){this.manager=t!==void 0?t:T0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};$c.DEFAULT_MATERIAL_NAME="__DEFAULT";var pc=new J,mc=new Kn,qn=new J,mr=class extends hn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Oe,this.projectionMatrix=new Oe,this.projectionMatrixInverse=new Oe,this.coordinateSystem=vn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pc,mc,qn),qn.x===1&&qn.y===1&&qn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pc,mc,qn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(pc,mc,qn),qn.x===1&&qn.y===1&&qn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pc,mc,qn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new J,zg=new ge,Vg=new ge,cn=class extends mr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Rc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(rd*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Rc*2*Math.atan(Math.tan(rd*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Us.x,Us.y).multiplyScalar(-t/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Us.x,Us.y).multiplyScalar(-t/Us.z)}getViewSize(t,e){return this.getViewBounds(t,zg,Vg),e.subVectors(Vg,zg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(rd*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var qc=class extends mr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=d*this.view.offsetY,l=a-d*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ho=-90,uo=1,yo=class extends hn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new cn(ho,uo,t,e);s.layers=this.layers,this.add(s);let r=new cn(ho,uo,t,e);r.layers=this.layers,this.add(r);let o=new cn(ho,uo,t,e);o.layers=this.layers,this.add(o);let a=new cn(ho,uo,t,e);a.layers=this.layers,this.add(a);let l=new cn(ho,uo,t,e);l.layers=this.layers,this.add(l);let c=new cn(ho,uo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===vn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ha)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,d]=this.children,u=t.getRenderTarget(),h=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,d),t.setRenderTarget(u,h,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Yc=class extends cn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var cf="\\[\\]\\.:\\/",gS=new RegExp("["+cf+"]","g"),hf="[^"+cf+"]",_S="[^"+cf.replace("\\.","")+"]",xS=/((?:WC+[\/:])*)/.source.replace("WC",hf),vS=/(WCOD+)?/.source.replace("WCOD",_S),yS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",hf),MS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",hf),SS=new RegExp("^"+xS+vS+yS+MS+"$"),bS=["material","materials","bones","map"],Id=class{constructor(t,e,i){let s=i||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ge=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(gS,"")}static parseTrackName(t){let e=SS.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);bS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let d=0;d<t.length;d++)if(t[d].name===c){c=d;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=Id;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var m2=new Float32Array(1);var Ld=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};function uf(n,t,e,i){let s=wS(i);switch(e){case jd:return n*t;case tf:return n*t/s.components*s.byteLength;case nh:return n*t/s.components*s.byteLength;case $s:return n*t*2/s.components*s.byteLength;case sh:return n*t*2/s.components*s.byteLength;case Qd:return n*t*3/s.components*s.byteLength;case qi:return n*t*4/s.components*s.byteLength;case rh:return n*t*4/s.components*s.byteLength;case Ea:case Ta:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Aa:case Ra:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ah:case ch:return Math.max(n,16)*Math.max(t,8)/4;case oh:case lh:return Math.max(n,8)*Math.max(t,8)/2;case hh:case uh:case fh:case ph:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case dh:case Ca:case mh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case gh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case _h:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case xh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case vh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case yh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Mh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Sh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case bh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case wh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Eh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Th:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Ah:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Rh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Ch:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Ph:case Ih:case Lh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Nh:case Dh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Pa:case Fh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function wS(n){switch(n){case dn:case Yd:return{byteLength:1,components:1};case wo:case Zd:case Un:return{byteLength:2,components:1};case eh:case ih:return{byteLength:2,components:4};case Fn:case th:case $i:return{byteLength:4,components:1};case Kd:case Jd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Y0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function TS(n){let t=new WeakMap;function e(a,l){let c=a.array,d=a.usage,u=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,d),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let d=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,d);else{u.sort((f,g)=>f.start-g.start);let h=0;for(let f=1;f<u.length;f++){let g=u[h],_=u[f];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++h,u[h]=_)}u.length=h+1;for(let f=0,g=u.length;f<g;f++){let _=u[f];n.bufferSubData(c,_.start*d.BYTES_PER_ELEMENT,d,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let d=t.get(a);(!d||d.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var AS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,RS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,CS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,PS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,IS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,LS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,NS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,DS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,FS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,US=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,OS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,kS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,BS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,zS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,VS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,HS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,GS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,WS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,XS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,$S=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,qS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,YS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ZS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,KS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,JS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,jS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,QS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,tb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,eb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ib="gl_FragColor = linearToOutputTexel( gl_FragColor );",nb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,sb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,rb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ob=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,ab=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,lb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,cb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,hb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ub=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,db=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,fb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,pb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,mb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,gb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,_b=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,xb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,vb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,yb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Mb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Sb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,bb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,wb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Eb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Tb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Ab=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Rb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Cb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Pb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ib=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Lb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Nb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Db=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Fb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ub=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ob=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,kb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Bb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,zb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Vb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Hb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Gb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Wb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Xb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,$b=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,qb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Zb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Kb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Jb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,jb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Qb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,tw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ew=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,iw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,nw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,sw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,rw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ow=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,aw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,lw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,cw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,hw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,uw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,dw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,fw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,pw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,mw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,gw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,_w=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,xw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,vw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,yw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Mw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Sw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,bw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,ww=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Ew=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Tw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Aw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Rw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Cw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Pw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Iw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Lw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Nw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Dw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Fw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Uw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ow=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Bw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,zw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Vw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Gw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ww=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Xw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$w=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,qw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Yw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Zw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Kw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Jw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,jw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Qw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,t1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,e1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,i1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,n1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,s1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,r1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,le={alphahash_fragment:AS,alphahash_pars_fragment:RS,alphamap_fragment:CS,alphamap_pars_fragment:PS,alphatest_fragment:IS,alphatest_pars_fragment:LS,aomap_fragment:NS,aomap_pars_fragment:DS,batching_pars_vertex:FS,batching_vertex:US,begin_vertex:OS,beginnormal_vertex:kS,bsdfs:BS,iridescence_fragment:zS,bumpmap_pars_fragment:VS,clipping_planes_fragment:HS,clipping_planes_pars_fragment:GS,clipping_planes_pars_vertex:WS,clipping_planes_vertex:XS,color_fragment:$S,color_pars_fragment:qS,color_pars_vertex:YS,color_vertex:ZS,common:KS,defaultnormal_vertex:JS,displacementmap_pars_vertex:jS,displacementmap_vertex:QS,emissivemap_fragment:tb,emissivemap_pars_fragment:eb,colorspace_fragment:ib,colorspace_pars_fragment:nb,envmap_fragment:sb,envmap_common_pars_fragment:rb,envmap_pars_fragment:ob,envmap_pars_vertex:ab,envmap_physical_pars_fragment:xb,envmap_vertex:lb,fog_vertex:cb,fog_pars_vertex:hb,fog_fragment:ub,fog_pars_fragment:db,gradientmap_pars_fragment:fb,lightmap_pars_fragment:pb,lights_lambert_fragment:mb,lights_lambert_pars_fragment:gb,lights_pars_begin:_b,lights_toon_fragment:vb,lights_toon_pars_fragment:yb,lights_phong_fragment:Mb,lights_phong_pars_fragment:Sb,lights_physical_fragment:bb,lights_physical_pars_fragment:wb,lights_fragment_begin:Eb,lights_fragment_maps:Tb,lights_fragment_end:Ab,lightprobes_pars_fragment:Rb,logdepthbuf_fragment:Cb,logdepthbuf_pars_fragment:Pb,logdepthbuf_pars_vertex:Ib,logdepthbuf_vertex:Lb,map_fragment:Nb,map_pars_fragment:Db,map_particle_fragment:Fb,map_particle_pars_fragment:Ub,metalnessmap_fragment:Ob,metalnessmap_pars_fragment:kb,morphinstance_vertex:Bb,morphcolor_vertex:zb,morphnormal_vertex:Vb,morphtarget_pars_vertex:Hb,morphtarget_vertex:Gb,normal_fragment_begin:Wb,normal_fragment_maps:Xb,normal_pars_fragment:$b,normal_pars_vertex:qb,normal_vertex:Yb,normalmap_pars_fragment:Zb,clearcoat_normal_fragment_begin:Kb,clearcoat_normal_fragment_maps:Jb,clearcoat_pars_fragment:jb,iridescence_pars_fragment:Qb,opaque_fragment:tw,packing:ew,premultiplied_alpha_fragment:iw,project_vertex:nw,dithering_fragment:sw,dithering_pars_fragment:rw,roughnessmap_fragment:ow,roughnessmap_pars_fragment:aw,shadowmap_pars_fragment:lw,shadowmap_pars_vertex:cw,shadowmap_vertex:hw,shadowmask_pars_fragment:uw,skinbase_vertex:dw,skinning_pars_vertex:fw,skinning_vertex:pw,skinnormal_vertex:mw,specularmap_fragment:gw,specularmap_pars_fragment:_w,tonemapping_fragment:xw,tonemapping_pars_fragment:vw,transmission_fragment:yw,transmission_pars_fragment:Mw,uv_pars_fragment:Sw,uv_pars_vertex:bw,uv_vertex:ww,worldpos_vertex:Ew,background_vert:Tw,background_frag:Aw,backgroundCube_vert:Rw,backgroundCube_frag:Cw,cube_vert:Pw,cube_frag:Iw,depth_vert:Lw,depth_frag:Nw,distance_vert:Dw,distance_frag:Fw,equirect_vert:Uw,equirect_frag:Ow,linedashed_vert:kw,linedashed_frag:Bw,meshbasic_vert:zw,meshbasic_frag:Vw,meshlambert_vert:Hw,meshlambert_frag:Gw,meshmatcap_vert:Ww,meshmatcap_frag:Xw,meshnormal_vert:$w,meshnormal_frag:qw,meshphong_vert:Yw,meshphong_frag:Zw,meshphysical_vert:Kw,meshphysical_frag:Jw,meshtoon_vert:jw,meshtoon_frag:Qw,points_vert:t1,points_frag:e1,shadow_vert:i1,shadow_frag:n1,sprite_vert:s1,sprite_frag:r1},Lt={common:{diffuse:{value:new _e(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new _e(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new _e(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new _e(16777215)},opacity:{value:1},center:{value:new ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},ts={basic:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:le.meshbasic_vert,fragmentShader:le.meshbasic_frag},lambert:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},envMapIntensity:{value:1}}]),vertexShader:le.meshlambert_vert,fragmentShader:le.meshlambert_frag},phong:{uniforms:Oi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},specular:{value:new _e(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:le.meshphong_vert,fragmentShader:le.meshphong_frag},standard:{uniforms:Oi([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:le.meshphysical_vert,fragmentShader:le.meshphysical_frag},toon:{uniforms:Oi([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new _e(0)}}]),vertexShader:le.meshtoon_vert,fragmentShader:le.meshtoon_frag},matcap:{uniforms:Oi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:le.meshmatcap_vert,fragmentShader:le.meshmatcap_frag},points:{uniforms:Oi([Lt.points,Lt.fog]),vertexShader:le.points_vert,fragmentShader:le.points_frag},dashed:{uniforms:Oi([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:le.linedashed_vert,fragmentShader:le.linedashed_frag},depth:{uniforms:Oi([Lt.common,Lt.displacementmap]),vertexShader:le.depth_vert,fragmentShader:le.depth_frag},normal:{uniforms:Oi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:le.meshnormal_vert,fragmentShader:le.meshnormal_frag},sprite:{uniforms:Oi([Lt.sprite,Lt.fog]),vertexShader:le.sprite_vert,fragmentShader:le.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:le.background_vert,fragmentShader:le.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:le.backgroundCube_vert,fragmentShader:le.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:le.cube_vert,fragmentShader:le.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:le.equirect_vert,fragmentShader:le.equirect_frag},distance:{uniforms:Oi([Lt.common,Lt.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:le.distance_vert,fragmentShader:le.distance_frag},shadow:{uniforms:Oi([Lt.lights,Lt.fog,{color:{value:new _e(0)},opacity:{value:1}}]),vertexShader:le.shadow_vert,fragmentShader:le.shadow_frag}};ts.physical={uniforms:Oi([ts.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new _e(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new _e(0)},specularColor:{value:new _e(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:le.meshphysical_vert,fragmentShader:le.meshphysical_frag};var Uh={r:0,b:0,g:0},o1=new Oe,Z0=new Qt;Z0.set(-1,0,0,0,1,0,0,0,1);function a1(n,t,e,i,s,r){let o=new _e(0),a=s===!0?0:1,l,c,d=null,u=0,h=null;function f(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let M=y.backgroundBlurriness>0;A=t.get(A,M)}return A}function g(y){let A=!1,M=f(y);M===null?m(o,a):M&&M.isColor&&(m(M,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(y,A){let M=f(A);M&&M.isCubeTexture?(c===void 0&&(c=new Mi(new xo(1,1,1),new Jn({name:"BackgroundCubeMaterial",uniforms:vr(ts.backgroundCube.uniforms),vertexShader:ts.backgroundCube.vertexShader,fragmentShader:ts.backgroundCube.fragmentShader,side:Xi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(o1.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Z0),c.material.toneMapped=me.getTransfer(M.colorSpace)!==Ee,(d!==M||u!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,d=M,u=M.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Mi(new ya(2,2),new Jn({name:"BackgroundMaterial",uniforms:vr(ts.background.uniforms),vertexShader:ts.background.vertexShader,fragmentShader:ts.background.fragmentShader,side:Xs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=me.getTransfer(M.colorSpace)!==Ee,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(d!==M||u!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,d=M,u=M.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,A){y.getRGB(Uh,lf(n)),e.buffers.color.setClear(Uh.r,Uh.g,Uh.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:g,addToRenderList:_,dispose:p}}function l1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,G,W,N,V){let X=!1,O=u(L,N,W,G);r!==O&&(r=O,c(r.object)),X=f(L,N,W,V),X&&g(L,N,W,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,M(L,G,W,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function d(L){return n.deleteVertexArray(L)}function u(L,G,W,N){let V=N.wireframe===!0,X=i[G.id];X===void 0&&(X={},i[G.id]=X);let O=L.isInstancedMesh===!0?L.id:0,lt=X[O];lt===void 0&&(lt={},X[O]=lt);let Z=lt[W.id];Z===void 0&&(Z={},lt[W.id]=Z);let Q=Z[V];return Q===void 0&&(Q=h(l()),Z[V]=Q),Q}function h(L){let G=[],W=[],N=[];for(let V=0;V<e;V++)G[V]=0,W[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:N,object:L,attributes:{},index:null}}function f(L,G,W,N){let V=r.attributes,X=G.attributes,O=0,lt=W.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let st=V[Z],dt=X[Z];if(dt===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(dt=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(dt=L.instanceColor)),st===void 0||st.attribute!==dt||dt&&st.data!==dt.data)return!0;O++}return r.attributesNum!==O||r.index!==N}function g(L,G,W,N){let V={},X=G.attributes,O=0,lt=W.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let st=X[Z];st===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(st=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(st=L.instanceColor));let dt={};dt.attribute=st,st&&st.data&&(dt.data=st.data),V[Z]=dt,O++}r.attributes=V,r.attributesNum=O,r.index=N}function _(){let L=r.newAttributes;for(let G=0,W=L.length;G<W;G++)L[G]=0}function m(L){p(L,0)}function p(L,G){let W=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;W[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),V[L]!==G&&(n.vertexAttribDivisor(L,G),V[L]=G)}function y(){let L=r.newAttributes,G=r.enabledAttributes;for(let W=0,N=G.length;W<N;W++)G[W]!==L[W]&&(n.disableVertexAttribArray(W),G[W]=0)}function A(L,G,W,N,V,X,O){O===!0?n.vertexAttribIPointer(L,G,W,V,X):n.vertexAttribPointer(L,G,W,N,V,X)}function M(L,G,W,N){_();let V=N.attributes,X=W.getAttributes(),O=G.defaultAttributeValues;for(let lt in X){let Z=X[lt];if(Z.location>=0){let Q=V[lt];if(Q===void 0&&(lt==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),lt==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let st=Q.normalized,dt=Q.itemSize,ut=t.get(Q);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,At=mt===n.INT||mt===n.UNSIGNED_INT||Q.gpuType===th;if(Q.isInterleavedBufferAttribute){let St=Q.data,Gt=St.isInterleavedBuffer===!0?St.stride:St.itemSize,ie=Q.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let Vt=0;Vt<Z.locationSize;Vt++)p(Z.location+Vt,St.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let Vt=0;Vt<Z.locationSize;Vt++)m(Z.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<Z.locationSize;Vt++)A(Z.location+Vt,dt/Z.locationSize,mt,st,Gt*xt,(ie+dt/Z.locationSize*Vt)*xt,At)}else{if(Q.isInstancedBufferAttribute){for(let St=0;St<Z.locationSize;St++)p(Z.location+St,Q.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let St=0;St<Z.locationSize;St++)m(Z.location+St);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let St=0;St<Z.locationSize;St++)A(Z.location+St,dt/Z.locationSize,mt,st,dt*xt,dt/Z.locationSize*St*xt,At)}}else if(O!==void 0){let st=O[lt];if(st!==void 0)switch(st.length){case 2:n.vertexAttrib2fv(Z.location,st);break;case 3:n.vertexAttrib3fv(Z.location,st);break;case 4:n.vertexAttrib4fv(Z.location,st);break;default:n.vertexAttrib1fv(Z.location,st)}}}}y()}function R(){k();for(let L in i){let G=i[L];for(let W in G){let N=G[W];for(let V in N){let X=N[V];for(let O in X)d(X[O].object),delete X[O];delete N[V]}}delete i[L]}}function T(L){if(i[L.id]===void 0)return;let G=i[L.id];for(let W in G){let N=G[W];for(let V in N){let X=N[V];for(let O in X)d(X[O].object),delete X[O];delete N[V]}}delete i[L.id]}function v(L){for(let G in i){let W=i[G];for(let N in W){let V=W[N];if(V[L.id]===void 0)continue;let X=V[L.id];for(let O in X)d(X[O].object),delete X[O];delete V[L.id]}}}function E(L){for(let G in i){let W=i[G],N=L.isInstancedMesh===!0?L.id:0,V=W[N];if(V!==void 0){for(let X in V){let O=V[X];for(let lt in O)d(O[lt].object),delete O[lt];delete V[X]}delete W[N],Object.keys(W).length===0&&delete i[G]}}}function k(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:_,enableAttribute:m,disableUnusedAttributes:y}}function c1(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,d){d!==0&&(n.drawArraysInstanced(i,l,c,d),e.update(c,i,d))}function a(l,c,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,d);let h=0;for(let f=0;f<d;f++)h+=c[f];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function h1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==qi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===Un&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==dn&&v!==$i&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",d=l(c);d!==c&&(Yt("WebGLRenderer:",c,"not supported, using",d,"instead."),c=d);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:M,maxSamples:R,samples:T}}function u1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Dn,a=new Qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,h){let f=u.length!==0||h||i!==0||s;return s=h,i=u.length,f},this.beginShadows=function(){r=!0,d(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,h){e=d(u,h,0)},this.setState=function(u,h,f){let g=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,p=n.get(u);if(!s||g===null||g.length===0||r&&!m)r?d(null):c();else{let y=r?0:i,A=y*4,M=p.clippingState||null;l.value=M,M=d(g,h,A,f);for(let R=0;R!==A;++R)M[R]=e[R];p.clippingState=M,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function d(u,h,f,g){let _=u!==null?u.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let p=f+_*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,M=f;A!==_;++A,M+=4)o.copy(u[A]).applyMatrix4(y,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Ua=class extends Wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new _a(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new xo(5,5,5),r=new Jn({name:"CubemapFromEquirect",uniforms:vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Xi,blending:xs});r.uniforms.tEquirect.value=e;let o=new Mi(s,r),a=e.minFilter;return e.minFilter===vs&&(e.minFilter=Pi),new yo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},A0=256,d1=3,f1=20,K0=256,J0=16,p1=3,m1=new J,g1=new _e,kh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new yo(1,10,null),this._boxMesh=new Mi(new xo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=m1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),d=this._getSourceTarget(!0);e>0&&(d.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(g1));let m=new yo(i,s,d);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=g,t.background=_,e>0&&(d.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=P0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=C0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(A0,S0(t))}_fromTexture(t,e){t.mapping===_r||t.mapping===bo?this._setSize(t.image.length===0?A0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=R0(t,!1,!1),i=Math.log2(t)-d1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=R0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===_r||t.mapping===bo?(this._cubemapMaterial===null&&(this._cubemapMaterial=P0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=C0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=_1(),this._integrationMaterial=x1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/J0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-p1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(K0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=v1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function R0(n,t,e){return new Ua(n,{minFilter:vs,generateMipmaps:t,type:Un,colorSpace:ks,depthBuffer:e})}function Oa(n,t,e){return new Jn({name:n,uniforms:t,vertexShader:le.cube_vert,fragmentShader:e,side:Xi,blending:xs,depthTest:!1,depthWrite:!1})}function _1(){return Oa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${K0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function x1(){return Oa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:J0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function v1(){return Oa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${f1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function C0(){return Oa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function P0(){return Oa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function y1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===Jc||f===jc)if(t.has(h)){let g=t.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let _=new Ua(g.height);return _.fromEquirectangularTexture(n,h),t.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,g=f===Jc||f===jc,_=f===_r||f===bo;if(g||_){let m=e.get(h),p=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new kh(n)),m=g?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let y=h.image;return g&&y&&y.height>0||_&&y&&l(y)?(i===null&&(i=new kh(n)),m=g?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",d),m.texture):null}}}return h}function a(h,f){return f===Jc?h.mapping=_r:f===jc&&(h.mapping=bo),h}function l(h){let f=0,g=6;for(let _=0;_<g;_++)h[_]!==void 0&&f++;return f===g}function c(h){let f=h.target;f.removeEventListener("dispose",c);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function d(h){let f=h.target;f.removeEventListener("dispose",d);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function M1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&aa("WebGLRenderer: "+i+" extension not supported."),s}}}function S1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(t.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function d(g){let _=g.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function u(g){let _=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let y=_!==null?_.array.length:m.array.length/3-1,A=m.count>=65535?ma:pa,M=new A(Math.ceil(y/3)*6,1),R=M.array;if(_!==null){let v=_.array;p=_.version;for(let E=0,k=0;E<y;E+=3){let D=v[E+0],L=v[E+1],G=v[E+2];R[k++]=D,R[k++]=L,R[k++]=L,R[k++]=G,R[k++]=G,R[k++]=D}}else{p=m.version;for(let v=0,E=0;v<y;v+=3){let k=v+0,D=v+1,L=v+2;R[E++]=k,R[E++]=D,R[E++]=D,R[E++]=L,R[E++]=L,R[E++]=k}}M.version=p;let T=r.get(g);T&&t.remove(T),r.set(g,M)}function h(g){let _=r.get(g);if(_){let m=g.index;m!==null&&_.version<m.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:d,getWireframeAttribute:h,dispose:f}}function b1(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,h){n.drawElements(i,h,r,u*o),e.update(h,i,1)}function c(u,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,u*o,f),e.update(h,i,f))}function d(u,h,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,u,0,f);let _=0;for(let m=0;m<f;m++)_+=h[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=d}function w1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function E1(n,t,e){let i=new WeakMap,s=new Je;function r(o,a,l){let c=o.morphTargetInfluences,d=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=d!==void 0?d.length:0,h=i.get(a);if(h===void 0||h.count!==u){let k=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",k)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;f===!0&&(A=1),g===!0&&(A=2),_===!0&&(A=3);let M=a.attributes.position.count*A,R=1;M>t.maxTextureSize&&(R=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let T=new Float32Array(M*R*4*u),v=new da(T,M,R,u);v.type=$i,v.needsUpdate=!0;let E=A*4;for(let D=0;D<u;D++){let L=m[D],G=p[D],W=y[D],N=M*R*4*D;for(let V=0;V<L.count;V++){let X=V*E;f===!0&&(s.fromBufferAttribute(L,V),T[N+X+0]=s.x,T[N+X+1]=s.y,T[N+X+2]=s.z,T[N+X+3]=0),g===!0&&(s.fromBufferAttribute(G,V),T[N+X+4]=s.x,T[N+X+5]=s.y,T[N+X+6]=s.z,T[N+X+7]=0),_===!0&&(s.fromBufferAttribute(W,V),T[N+X+8]=s.x,T[N+X+9]=s.y,T[N+X+10]=s.z,T[N+X+11]=W.itemSize===4?s.w:1)}}h={count:u,texture:v,size:new ge(M,R)},i.set(a,h),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function T1(n,t,e,i,s){let r=new WeakMap;function o(c){let d=s.render.frame,u=c.geometry,h=t.get(c,u);if(r.get(h)!==d&&(t.update(h),r.set(h,d)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==d&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,d))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==d&&(f.update(),r.set(f,d))}return h}function a(){r=new WeakMap}function l(c){let d=c.target;d.removeEventListener("dispose",l),i.releaseStatesOfObject(d),e.remove(d.instanceMatrix),d.instanceColor!==null&&e.remove(d.instanceColor)}return{update:o,dispose:a}}var A1={[zd]:"LINEAR_TONE_MAPPING",[Vd]:"REINHARD_TONE_MAPPING",[Hd]:"CINEON_TONE_MAPPING",[Gd]:"ACES_FILMIC_TONE_MAPPING",[Xd]:"AGX_TONE_MAPPING",[$d]:"NEUTRAL_TONE_MAPPING",[Wd]:"CUSTOM_TONE_MAPPING"};function R1(n,t,e,i,s,r){let o=new Wi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,d=new mi;d.setAttribute("position",new yn([-1,3,0,-1,-1,0,3,-1,0],3)),d.setAttribute("uv",new yn([0,2,0,0,2,0],2));let u=new vo({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Mi(d,u),f=new qc(-1,1,1,-1,0,1),g=null,_=null,m=!1,p,y=null,A=[],M=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),l!==null&&l.setSize(R,T);for(let v=0;v<A.length;v++){let E=A[v];E.setSize&&E.setSize(R,T)}},this.setEffects=function(R){A=R,M=A.length>0&&A[0].isRenderPass===!0;let T=o.width,v=o.height;A.length>0&&a===null&&(a=new Wi(T,v,{type:Un,depthBuffer:!1,stencilBuffer:!1}),l=new Wi(T,v,{type:Un,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new _s(T,v),r===!0&&(c.format=ys,c.type=xr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<A.length;k++){let D=A[k];D.setSize&&D.setSize(T,v),E&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(R,T){if(m||R.toneMapping===jn&&A.length===0)return!1;if(y=T,T!==null){let v=T.width,E=T.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return M===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=jn,!0},this.hasRenderPass=function(){return M},this.end=function(R,T){R.toneMapping=p,m=!0;let v=o,E=a;for(let k=0;k<A.length;k++){let D=A[k];D.enabled!==!1&&(D.render(R,E,v,T),D.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(g!==R.outputColorSpace||_!==R.toneMapping){g=R.outputColorSpace,_=R.toneMapping,u.defines={},me.getTransfer(g)===Ee&&(u.defines.SRGB_TRANSFER="");let k=A1[_];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(y),R.render(h,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),d.dispose(),u.dispose()}}var j0=new Ki,Q0=new _s(1,1),t_=new xa(1),e_=new da,i_=new Ic,n_=new _a,I0=[],L0=[],N0=new Float32Array(16),D0=new Float32Array(9),F0=new Float32Array(4);function To(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=I0[s];if(r===void 0&&(r=new Float32Array(s),I0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Si(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function bi(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function zh(n,t){let e=L0[t];e===void 0&&(e=new Int32Array(t),L0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function C1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function P1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Si(e,t))return;n.uniform2fv(this.addr,t),bi(e,t)}}function I1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Si(e,t))return;n.uniform3fv(this.addr,t),bi(e,t)}}function L1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Si(e,t))return;n.uniform4fv(this.addr,t),bi(e,t)}}function N1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Si(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),bi(e,t)}else{if(Si(e,i))return;F0.set(i),n.uniformMatrix2fv(this.addr,!1,F0),bi(e,i)}}function D1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Si(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),bi(e,t)}else{if(Si(e,i))return;D0.set(i),n.uniformMatrix3fv(this.addr,!1,D0),bi(e,i)}}function F1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Si(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),bi(e,t)}else{if(Si(e,i))return;N0.set(i),n.uniformMatrix4fv(this.addr,!1,N0),bi(e,i)}}function U1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function O1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Si(e,t))return;n.uniform2iv(this.addr,t),bi(e,t)}}function k1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Si(e,t))return;n.uniform3iv(this.addr,t),bi(e,t)}}function B1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Si(e,t))return;n.uniform4iv(this.addr,t),bi(e,t)}}function z1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function V1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Si(e,t))return;n.uniform2uiv(this.addr,t),bi(e,t)}}function H1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Si(e,t))return;n.uniform3uiv(this.addr,t),bi(e,t)}}function G1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Si(e,t))return;n.uniform4uiv(this.addr,t),bi(e,t)}}function Vh(n){return n.version===0&&(n.compareFunction=rf,n.needsUpdate=!0),n}function W1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Vh(Q0):r=j0,e.setTexture2D(t||r,s)}function X1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||i_,s)}function $1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Vh(t_):r=n_,e.setTextureCube(t||r,s)}function q1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||e_,s)}function Y1(n){switch(n){case 5126:return C1;case 35664:return P1;case 35665:return I1;case 35666:return L1;case 35674:return N1;case 35675:return D1;case 35676:return F1;case 5124:case 35670:return U1;case 35667:case 35671:return O1;case 35668:case 35672:return k1;case 35669:case 35673:return B1;case 5125:return z1;case 36294:return V1;case 36295:return H1;case 36296:return G1;case 35678:case 36198:case 36298:case 36306:case 35682:return W1;case 35679:case 36299:case 36307:return X1;case 35680:case 36300:case 36308:case 36293:return $1;case 36289:case 36303:case 36311:case 36292:return q1}}function Z1(n,t){n.uniform1fv(this.addr,t)}function K1(n,t){let e=To(t,this.size,2);n.uniform2fv(this.addr,e)}function J1(n,t){let e=To(t,this.size,3);n.uniform3fv(this.addr,e)}function j1(n,t){let e=To(t,this.size,4);n.uniform4fv(this.addr,e)}function Q1(n,t){let e=To(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function tE(n,t){let e=To(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function eE(n,t){let e=To(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function iE(n,t){n.uniform1iv(this.addr,t)}function nE(n,t){n.uniform2iv(this.addr,t)}function sE(n,t){n.uniform3iv(this.addr,t)}function rE(n,t){n.uniform4iv(this.addr,t)}function oE(n,t){n.uniform1uiv(this.addr,t)}function aE(n,t){n.uniform2uiv(this.addr,t)}function lE(n,t){n.uniform3uiv(this.addr,t)}function cE(n,t){n.uniform4uiv(this.addr,t)}function hE(n,t,e){let i=this.cache,s=t.length,r=zh(e,s);Si(i,r)||(n.uniform1iv(this.addr,r),bi(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Vh(Q0):o=j0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function uE(n,t,e){let i=this.cache,s=t.length,r=zh(e,s);Si(i,r)||(n.uniform1iv(this.addr,r),bi(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||i_,r[o])}function dE(n,t,e){let i=this.cache,s=t.length,r=zh(e,s);Si(i,r)||(n.uniform1iv(this.addr,r),bi(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Vh(t_):o=n_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function fE(n,t,e){let i=this.cache,s=t.length,r=zh(e,s);Si(i,r)||(n.uniform1iv(this.addr,r),bi(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||e_,r[o])}function pE(n){switch(n){case 5126:return Z1;case 35664:return K1;case 35665:return J1;case 35666:return j1;case 35674:return Q1;case 35675:return tE;case 35676:return eE;case 5124:case 35670:return iE;case 35667:case 35671:return nE;case 35668:case 35672:return sE;case 35669:case 35673:return rE;case 5125:return oE;case 36294:return aE;case 36295:return lE;case 36296:return cE;case 35678:case 36198:case 36298:case 36306:case 35682:return hE;case 35679:case 36299:case 36307:return uE;case 35680:case 36300:case 36308:case 36293:return dE;case 36289:case 36303:case 36311:case 36292:return fE}}var pf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Y1(e.type)}},mf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=pE(e.type)}},gf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},df=/(\w+)(\])?(\[|\.)?/g;function U0(n,t){n.seq.push(t),n.map[t.id]=t}function mE(n,t,e){let i=n.name,s=i.length;for(df.lastIndex=0;;){let r=df.exec(i),o=df.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){U0(e,c===void 0?new pf(a,n,t):new mf(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new gf(a),U0(e,u)),e=u}}}var Eo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);mE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function O0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var gE=37297,_E=0;function xE(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var k0=new Qt;function vE(n){me._getMatrix(k0,me.workingColorSpace,n);let t=`mat3( ${k0.elements.map(e=>e.toFixed(4))} )`;switch(me.getTransfer(n)){case ca:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function B0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+xE(n.getShaderSource(t),a)}else return r}function yE(n,t){let e=vE(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ME={[zd]:"Linear",[Vd]:"Reinhard",[Hd]:"Cineon",[Gd]:"ACESFilmic",[Xd]:"AgX",[$d]:"Neutral",[Wd]:"Custom"};function SE(n,t){let e=ME[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Oh=new J;function bE(){me.getLuminanceCoefficients(Oh);let n=Oh.x.toFixed(4),t=Oh.y.toFixed(4),e=Oh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function wE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function EE(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function TE(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Fa(n){return n!==""}function z0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function V0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var AE=/^[ \t]*#include +<([\w\d./]+)>/gm;function _f(n){return n.replace(AE,RE)}function RE(n,t){let e=le[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return _f(e)}var CE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function H0(n){return n.replace(CE,PE)}function PE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function G0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var IE={[Sa]:"SHADOWMAP_TYPE_PCF",[Mo]:"SHADOWMAP_TYPE_VSM"};function LE(n){return IE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var NE={[bo]:"ENVMAP_MODE_REFRACTION"};function DE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":NE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var FE={[Bd]:"ENVMAP_BLENDING_MULTIPLY",[o0]:"ENVMAP_BLENDING_MIX",[a0]:"ENVMAP_BLENDING_ADD"};function UE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":FE[n.combine]||"ENVMAP_BLENDING_NONE"}function OE(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=LE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=DE(e),u=UE(e),h=wE(e),f=EE(r),g=s.createProgram(),_,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Fa).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Fa).join(`
`),m.length>0&&(m+=`
`)):(_=[G0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+d:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),m=[G0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+d:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==jn?"#define TONE_MAPPING":"",e.toneMapping!==jn?le.tonemapping_pars_fragment:"",e.toneMapping!==jn?SE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",le.colorspace_pars_fragment,yE("linearToOutputTexel",e.outputColorSpace),bE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=_f(o),o=z0(o,e),o=V0(o,e),a=_f(a),a=z0(a,e),a=V0(a,e),o=H0(o),a=H0(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===La?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===La?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=p+_+o,A=p+m+a,M=O0(s,s.VERTEX_SHADER,y),R=O0(s,s.FRAGMENT_SHADER,A);s.attachShader(g,M),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(D){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(R)||"",N=L.trim(),V=G.trim(),X=W.trim(),O=!0,lt=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,M,R);else{let Z=B0(s,M,"vertex"),Q=B0(s,R,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+N+`
`+Z+`
`+Q)}else N!==""?Yt("WebGLProgram: Program Info Log:",N):(V===""||X==="")&&(lt=!1);lt&&(D.diagnostics={runnable:O,programLog:N,vertexShader:{log:V,prefix:_},fragmentShader:{log:X,prefix:m}})}s.deleteShader(M),s.deleteShader(R),v=new Eo(s,g),E=TE(s,g)}let v;this.getUniforms=function(){return v===void 0&&T(this),v};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,gE)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=_E++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=R,this}var kE=0,xf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new vf(t),e.set(t,i)),i}},vf=class{constructor(t){this.id=kE++,this.code=t,this.usedTimes=0}};function BE(n){return n===$s||n===Ca||n===Pa}function zE(n,t,e,i,s,r){let o=new fa,a=new xf,l=new Set,c=[],d=new Map,u=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,E,k,D,L,G){let W=D.fog,N=L.geometry,V=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?D.environment:null,X=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,O=t.get(v.envMap||V,X),lt=h[v.type],Z=i.precision;v.precision!==null&&(Z=i.getMaxPrecision(v.precision),Z!==v.precision&&Yt("WebGLProgram.getParameters:",v.precision,"not supported, using",Z,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,st=Q!==void 0?Q.length:0,dt=0;N.morphAttributes.position!==void 0&&(dt=1),N.morphAttributes.normal!==void 0&&(dt=2),N.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,xt;if(lt){let Rt=ts[lt];ut=Rt.vertexShader,tt=Rt.fragmentShader}else{ut=v.vertexShader,tt=v.fragmentShader;let Rt=a.getVertexShaderStage(v),se=a.getFragmentShaderStage(v);a.update(v,Rt,se),mt=Rt.id,xt=se.id}let At=n.getRenderTarget(),St=n.state.buffers.depth.getReversed(),Gt=L.isInstancedMesh===!0,ie=L.isBatchedMesh===!0,Vt=!!v.map,ce=!!v.matcap,re=!!O,te=re&&O.isPMREMTexture===!0,We=!!v.aoMap,Ue=!!v.lightMap,oi=!!v.bumpMap&&v.wireframe===!1,Ce=!!v.normalMap,wi=!!v.displacementMap,ve=!!v.emissiveMap,gi=!!v.metalnessMap,je=!!v.roughnessMap,ai=v.anisotropy>0,U=v.clearcoat>0,Ct=v.diffuseRoughness>0,$t=v.dispersion>0,ne=v.retroreflectivity>0,bt=v.iridescence>0,Le=v.sheen>0,zt=v.transmission>0,Xt=ai&&!!v.anisotropyMap,C=U&&!!v.clearcoatMap,S=U&&!!v.clearcoatNormalMap,$=U&&!!v.clearcoatRoughnessMap,ht=Ct&&!!v.diffuseRoughnessMap,ot=bt&&!!v.iridescenceMap,_t=bt&&!!v.iridescenceThicknessMap,vt=Le&&!!v.sheenColorMap,et=Le&&!!v.sheenRoughnessMap,nt=!!v.specularMap,pt=!!v.specularColorMap,F=!!v.specularIntensityMap,rt=zt&&!!v.transmissionMap,it=zt&&!!v.thicknessMap,wt=!!v.gradientMap,gt=!!v.alphaMap,Mt=v.alphaTest>0,Ht=!!v.alphaHash,Zt=!!v.extensions,ct=jn;v.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ot=te?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,Kt={shaderID:lt,shaderType:v.type,shaderName:v.name,vertexShader:ut,fragmentShader:tt,defines:v.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Z,batching:ie,batchingColor:ie&&L._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&L.instanceColor!==null,instancingMorph:Gt&&L.morphTexture!==null,outputColorSpace:At===null?n.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:me.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Vt,matcap:ce,envMap:re,envMapMode:re&&O.mapping,envMapPMREM:te,envMapMaxLod:te?Ot.length-1:null,envMapSize:te?Ot[0].width:null,aoMap:We,lightMap:Ue,bumpMap:oi,normalMap:Ce,displacementMap:wi,emissiveMap:ve,normalMapObjectSpace:Ce&&v.normalMapType===h0,normalMapTangentSpace:Ce&&v.normalMapType===ef,packedNormalMap:Ce&&v.normalMapType===ef&&BE(v.normalMap.format),metalnessMap:gi,roughnessMap:je,anisotropy:ai,anisotropyMap:Xt,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Ct,diffuseRoughnessMap:ht,dispersion:$t,retroreflection:ne,iridescence:bt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:Le,sheenColorMap:vt,sheenRoughnessMap:et,specularMap:nt,specularColorMap:pt,specularIntensityMap:F,transmission:zt,transmissionMap:rt,thicknessMap:it,gradientMap:wt,opaque:v.transparent===!1&&v.blending===So&&v.alphaToCoverage===!1,alphaMap:gt,alphaTest:Mt,alphaHash:Ht,combine:v.combine,mapUv:Vt&&f(v.map.channel),aoMapUv:We&&f(v.aoMap.channel),lightMapUv:Ue&&f(v.lightMap.channel),bumpMapUv:oi&&f(v.bumpMap.channel),normalMapUv:Ce&&f(v.normalMap.channel),displacementMapUv:wi&&f(v.displacementMap.channel),emissiveMapUv:ve&&f(v.emissiveMap.channel),metalnessMapUv:gi&&f(v.metalnessMap.channel),roughnessMapUv:je&&f(v.roughnessMap.channel),anisotropyMapUv:Xt&&f(v.anisotropyMap.channel),clearcoatMapUv:C&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(v.sheenRoughnessMap.channel),specularMapUv:nt&&f(v.specularMap.channel),specularColorMapUv:pt&&f(v.specularColorMap.channel),specularIntensityMapUv:F&&f(v.specularIntensityMap.channel),transmissionMapUv:rt&&f(v.transmissionMap.channel),thicknessMapUv:it&&f(v.thicknessMap.channel),alphaMapUv:gt&&f(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ce||ai),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(Vt||gt),fog:!!W,useFog:v.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Ce===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:St,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:dt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&v.map.isVideoTexture===!0&&me.getTransfer(v.map.colorSpace)===Ee,decodeVideoTextureEmissive:ve&&v.emissiveMap.isVideoTexture===!0&&me.getTransfer(v.emissiveMap.colorSpace)===Ee,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Mn,flipSided:v.side===Xi,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Zt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&v.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function _(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let k in v.defines)E.push(k),E.push(v.defines[k]);return v.isRawShaderMaterial===!1&&(m(E,v),p(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function m(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function p(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function y(v){let E=h[v.type],k;if(E){let D=ts[E];k=w0.clone(D.uniforms)}else k=v.uniforms;return k}function A(v,E){let k=d.get(E);return k!==void 0?++k.usedTimes:(k=new OE(n,E,v,s),c.push(k),d.set(E,k)),k}function M(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),d.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:y,acquireProgram:A,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:T}}function VE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function HE(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function W0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function X0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,g,_,m,p){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:f,material:g,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:m,group:p},n[t]=y):(y.id=h.id,y.object=h,y.geometry=f,y.material=g,y.materialVariant=o(h),y.groupOrder=_,y.renderOrder=h.renderOrder,y.z=m,y.group=p),t++,y}function l(h,f,g,_,m,p,y){y.reversedDepth===!0&&(m=-m);let A=a(h,f,g,_,m,p);g.transmission>0?i.push(A):g.transparent===!0?s.push(A):e.push(A)}function c(h,f,g,_,m,p){let y=a(h,f,g,_,m,p);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function d(h,f){e.length>1&&e.sort(h||HE),i.length>1&&i.sort(f||W0),s.length>1&&s.sort(f||W0)}function u(){for(let h=t,f=n.length;h<f;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:d}}function GE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new X0,n.set(i,[o])):s>=r.length?(o=new X0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function WE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new J,color:new _e};break;case"SpotLight":e={position:new J,direction:new J,color:new _e,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new J,color:new _e,distance:0,decay:0};break;case"HemisphereLight":e={direction:new J,skyColor:new _e,groundColor:new _e};break;case"RectAreaLight":e={color:new _e,position:new J,halfWidth:new J,halfHeight:new J};break}return n[t.id]=e,e}}}function XE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var $E=0;function qE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function YE(n){let t=new WE,e=XE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new J);let s=new J,r=new Oe,o=new Oe;function a(c){let d=0,u=0,h=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let f=0,g=0,_=0,m=0,p=0,y=0,A=0,M=0,R=0,T=0,v=0,E=0,k=0,D=0;c.sort(qE);for(let G=0,W=c.length;G<W;G++){let N=c[G],V=N.color,X=N.intensity,O=N.distance,lt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===$s?lt=N.shadow.map.texture:lt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)d+=V.r*X,u+=V.g*X,h+=V.b*X;else if(N.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(N.sh.coefficients[Z],X);D++}else if(N.isSunLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=st,i.sunShadowMap[g]=lt;let dt=Q.getViewportCount();for(let ut=0;ut<dt;ut++)i.sunShadowMatrix[_+ut]=Q.getMatrix(ut),i.sunShadowCascade[_+ut]=Q._cascadeData[ut];_+=dt,g++}i.sun[f]=Z,f++}else if(N.isDirectionalLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.directionalShadow[m]=st,i.directionalShadowMap[m]=lt,i.directionalShadowMatrix[m]=N.shadow.matrix,R++}i.directional[m]=Z,m++}else if(N.isSpotLight){let Z=t.get(N);Z.position.setFromMatrixPosition(N.matrixWorld),Z.color.copy(V).multiplyScalar(X),Z.distance=O,Z.coneCos=Math.cos(N.angle),Z.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Z.decay=N.decay,i.spot[y]=Z;let Q=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&k++),i.spotLightMatrix[y]=Q.matrix,N.castShadow){let st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.spotShadow[y]=st,i.spotShadowMap[y]=lt,v++}y++}else if(N.isRectAreaLight){let Z=t.get(N);Z.color.copy(V).multiplyScalar(X),Z.halfWidth.set(N.width*.5,0,0),Z.halfHeight.set(0,N.height*.5,0),i.rectArea[A]=Z,A++}else if(N.isPointLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),Z.distance=N.distance,Z.decay=N.decay,N.castShadow){let Q=N.shadow,st=e.get(N);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,i.pointShadow[p]=st,i.pointShadowMap[p]=lt,i.pointShadowMatrix[p]=N.shadow.matrix,T++}i.point[p]=Z,p++}else if(N.isHemisphereLight){let Z=t.get(N);Z.skyColor.copy(N.color).multiplyScalar(X),Z.groundColor.copy(N.groundColor).multiplyScalar(X),i.hemi[M]=Z,M++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=d,i.ambient[1]=u,i.ambient[2]=h;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==y||L.rectAreaLength!==A||L.hemiLength!==M||L.numSunShadows!==g||L.numDirectionalShadows!==R||L.numPointShadows!==T||L.numSpotShadows!==v||L.numSpotMaps!==E||L.numLightProbes!==D)&&(i.sun.length=f,i.directional.length=m,i.spot.length=y,i.rectArea.length=A,i.point.length=p,i.hemi.length=M,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=D,L.sunLength=f,L.directionalLength=m,L.pointLength=p,L.spotLength=y,L.rectAreaLength=A,L.hemiLength=M,L.numSunShadows=g,L.numDirectionalShadows=R,L.numPointShadows=T,L.numSpotShadows=v,L.numSpotMaps=E,L.numLightProbes=D,i.version=$E++)}function l(c,d){let u=0,h=0,f=0,g=0,_=0,m=0,p=d.matrixWorldInverse;for(let y=0,A=c.length;y<A;y++){let M=c[y];if(M.isSunLight){let R=i.sun[u];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),u++}else if(M.isDirectionalLight){let R=i.directional[h];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),h++}else if(M.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),g++}else if(M.isRectAreaLight){let R=i.rectArea[_];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(M.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),f++}else if(M.isHemisphereLight){let R=i.hemi[m];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function $0(n){let t=new YE(n),e=[],i=[],s=[];function r(u){d.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,h)=>u.priority-h.priority||u.id-h.id)}function c(u){t.setupView(e,u)}let d={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function ZE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new $0(n),t.set(s,[a])):r>=o.length?(a=new $0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var KE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,JE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,jE=[new J(1,0,0),new J(-1,0,0),new J(0,1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1)],QE=[new J(0,-1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1),new J(0,-1,0),new J(0,-1,0)],q0=new Oe,Da=new J,ff=new J;function tT(n,t,e){let i=new fr,s=new ge,r=new ge,o=new Je,a=new Fc,l=new Uc,c={},d=e.maxTextureSize,u={[Xs]:Xi,[Xi]:Xs,[Mn]:Mn},h=new Jn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ge},radius:{value:4}},vertexShader:KE,fragmentShader:JE}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let g=new mi;g.setAttribute("position",new ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Mi(g,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sa;let p=this.type;this.render=function(T,v,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===Wg&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Sa);let k=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),G=n.state;G.setBlending(xs),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=p!==this.type;W&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=T.length;N<V;N++){let X=T[N],O=X.shadow;if(O===void 0){Yt("WebGLShadowMap:",X,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let lt=O.getFrameExtents();s.multiply(lt),r.copy(O.mapSize),(s.x>d||s.y>d)&&(s.x>d&&(r.x=Math.floor(d/lt.x),s.x=r.x*lt.x,O.mapSize.x=r.x),s.y>d&&(r.y=Math.floor(d/lt.y),s.y=r.y*lt.y,O.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=Z,O.map===null||W===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Mo){if(X.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new Wi(s.x,s.y,{format:$s,type:Un,minFilter:Pi,magFilter:Pi,generateMipmaps:!1}),O.map.texture.name=X.name+".shadowMap",O.map.depthTexture=new _s(s.x,s.y,$i),O.map.depthTexture.name=X.name+".shadowMapDepth",O.map.depthTexture.format=ms,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=pi,O.map.depthTexture.magFilter=pi}else X.isPointLight?(O.map=new Ua(s.x),O.map.depthTexture=new xa(s.x,Fn)):(O.map=new Wi(s.x,s.y),O.map.depthTexture=new _s(s.x,s.y,Fn)),O.map.depthTexture.name=X.name+".shadowMap",O.map.depthTexture.format=ms,this.type===Sa?(O.map.depthTexture.compareFunction=Z?sf:nf,O.map.depthTexture.minFilter=Pi,O.map.depthTexture.magFilter=Pi):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=pi,O.map.depthTexture.magFilter=pi);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let Q=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();X.isPointLight!==!0&&O.updateMatrices(X,E);let st=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:E.layers;for(let dt=0;dt<Q;dt++){let ut=O.getCamera(dt);if(X.isPointLight){let tt=O.camera,mt=O.matrix,xt=X.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Da.setFromMatrixPosition(X.matrixWorld),tt.position.copy(Da),ff.copy(tt.position),ff.add(jE[dt]),tt.up.copy(QE[dt]),tt.lookAt(ff),tt.updateMatrixWorld(),mt.makeTranslation(-Da.x,-Da.y,-Da.z),q0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),O._frustum.setFromProjectionMatrix(q0,tt.coordinateSystem,tt.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(O.map),n.clear());let tt=O.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),G.viewport(o)}i=O.getFrustum(dt),M(v,E,ut,X,st,this.type)}O.isPointLightShadow!==!0&&this.type===Mo&&y(O,E),O.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(k,D,L)};function y(T,v){let E=t.update(_);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new Wi(s.x,s.y,{format:$s,type:Un}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(v,null,E,h,_,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(v,null,E,f,_,null)}function A(T,v,E,k){let D=null,L=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)D=L;else if(D=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let G=D.uuid,W=v.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let V=N[W];V===void 0&&(V=D.clone(),N[W]=V,v.addEventListener("dispose",R)),D=V}if(D.visible=v.visible,D.wireframe=v.wireframe,k===Mo?D.side=v.shadowSide!==null?v.shadowSide:v.side:D.side=v.shadowSide!==null?v.shadowSide:u[v.side],D.alphaMap=v.alphaMap,D.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,D.map=v.map,D.clipShadows=v.clipShadows,D.clippingPlanes=v.clippingPlanes,D.clipIntersection=v.clipIntersection,D.displacementMap=v.displacementMap,D.displacementScale=v.displacementScale,D.displacementBias=v.displacementBias,D.wireframeLinewidth=v.wireframeLinewidth,D.linewidth=v.linewidth,E.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let G=n.properties.get(D);G.light=E}return D}function M(T,v,E,k,D,L){if(T.visible===!1)return;if(T.layers.test(D)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&L===Mo)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let N=t.update(T),V=T.material;if(Array.isArray(V)){let X=N.groups;for(let O=0,lt=X.length;O<lt;O++){let Z=X[O],Q=V[Z.materialIndex];if(Q&&Q.visible){let st=A(T,Q,k,L);T.onBeforeShadow(n,T,v,E,N,st,Z),n.renderBufferDirect(E,null,N,st,T,Z),T.onAfterShadow(n,T,v,E,N,st,Z)}}}else if(V.visible){let X=A(T,V,k,L);T.onBeforeShadow(n,T,v,E,N,X,null),n.renderBufferDirect(E,null,N,X,T,null),T.onAfterShadow(n,T,v,E,N,X,null)}}let W=T.children;for(let N=0,V=W.length;N<V;N++)M(W[N],v,E,k,D,L)}function R(T){T.target.removeEventListener("dispose",R);for(let E in c){let k=c[E],D=T.target.uuid;D in k&&(k[D].dispose(),delete k[D])}}}function eT(n,t){function e(){let F=!1,rt=new Je,it=null,wt=new Je(0,0,0,0);return{setMask:function(gt){it!==gt&&!F&&(n.colorMask(gt,gt,gt,gt),it=gt)},setLocked:function(gt){F=gt},setClear:function(gt,Mt,Ht,Zt,ct){ct===!0&&(gt*=Zt,Mt*=Zt,Ht*=Zt),rt.set(gt,Mt,Ht,Zt),wt.equals(rt)===!1&&(n.clearColor(gt,Mt,Ht,Zt),wt.copy(rt))},reset:function(){F=!1,it=null,wt.set(-1,0,0,0)}}}function i(){let F=!1,rt=!1,it=null,wt=null,gt=null;return{setReversed:function(Mt){if(rt!==Mt){let Ht=t.get("EXT_clip_control");Mt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=Mt;let Zt=gt;gt=null,this.setClear(Zt)}},getReversed:function(){return rt},setTest:function(Mt){Mt?St(n.DEPTH_TEST):Gt(n.DEPTH_TEST)},setMask:function(Mt){it!==Mt&&!F&&(n.depthMask(Mt),it=Mt)},setFunc:function(Mt){if(rt&&(Mt=M0[Mt]),wt!==Mt){switch(Mt){case xc:n.depthFunc(n.NEVER);break;case vc:n.depthFunc(n.ALWAYS);break;case yc:n.depthFunc(n.LESS);break;case po:n.depthFunc(n.LEQUAL);break;case Mc:n.depthFunc(n.EQUAL);break;case Sc:n.depthFunc(n.GEQUAL);break;case bc:n.depthFunc(n.GREATER);break;case wc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}wt=Mt}},setLocked:function(Mt){F=Mt},setClear:function(Mt){gt!==Mt&&(gt=Mt,rt&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){F=!1,it=null,wt=null,gt=null,rt=!1}}}function s(){let F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,ct=null;return{setTest:function(Ot){F||(Ot?St(n.STENCIL_TEST):Gt(n.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!F&&(n.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Kt,Rt){(it!==Ot||wt!==Kt||gt!==Rt)&&(n.stencilFunc(Ot,Kt,Rt),it=Ot,wt=Kt,gt=Rt)},setOp:function(Ot,Kt,Rt){(Mt!==Ot||Ht!==Kt||Zt!==Rt)&&(n.stencilOp(Ot,Kt,Rt),Mt=Ot,Ht=Kt,Zt=Rt)},setLocked:function(Ot){F=Ot},setClear:function(Ot){ct!==Ot&&(n.clearStencil(Ot),ct=Ot)},reset:function(){F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,d={},u={},h={},f=new WeakMap,g=[],_=null,m=!1,p=null,y=null,A=null,M=null,R=null,T=null,v=null,E=new _e(0,0,0),k=0,D=!1,L=null,G=null,W=null,N=null,V=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,lt=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(Z)[1]),O=lt>=1):Z.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),O=lt>=2);let Q=null,st={},dt=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),tt=new Je().fromArray(dt),mt=new Je().fromArray(ut);function xt(F,rt,it,wt){let gt=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(F,Mt),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<it;Ht++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,wt,0,n.RGBA,n.UNSIGNED_BYTE,gt):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,gt);return Mt}let At={};At[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),At[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),At[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(n.DEPTH_TEST),o.setFunc(po),oi(!1),Ce(Nd),St(n.CULL_FACE),We(xs);function St(F){d[F]!==!0&&(n.enable(F),d[F]=!0)}function Gt(F){d[F]!==!1&&(n.disable(F),d[F]=!1)}function ie(F,rt){return h[F]!==rt?(n.bindFramebuffer(F,rt),h[F]=rt,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=rt),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(F,rt){let it=g,wt=!1;if(F){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let gt=F.textures;if(it.length!==gt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,Ht=gt.length;Mt<Ht;Mt++)it[Mt]=n.COLOR_ATTACHMENT0+Mt;it.length=gt.length,wt=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,wt=!0);wt&&n.drawBuffers(it)}function ce(F){return _!==F?(n.useProgram(F),_=F,!0):!1}let re={[gr]:n.FUNC_ADD,[Xg]:n.FUNC_SUBTRACT,[$g]:n.FUNC_REVERSE_SUBTRACT};re[Kc]=n.MIN,re[qg]=n.MAX;let te={[Yg]:n.ZERO,[ba]:n.ONE,[Zg]:n.SRC_COLOR,[Od]:n.SRC_ALPHA,[e0]:n.SRC_ALPHA_SATURATE,[Qg]:n.DST_COLOR,[Jg]:n.DST_ALPHA,[Kg]:n.ONE_MINUS_SRC_COLOR,[kd]:n.ONE_MINUS_SRC_ALPHA,[t0]:n.ONE_MINUS_DST_COLOR,[jg]:n.ONE_MINUS_DST_ALPHA,[i0]:n.CONSTANT_COLOR,[n0]:n.ONE_MINUS_CONSTANT_COLOR,[s0]:n.CONSTANT_ALPHA,[r0]:n.ONE_MINUS_CONSTANT_ALPHA};function We(F,rt,it,wt,gt,Mt,Ht,Zt,ct,Ot){if(F===xs){m===!0&&(Gt(n.BLEND),m=!1);return}if(m===!1&&(St(n.BLEND),m=!0),F!==Zc){if(F!==p||Ot!==D){if((y!==gr||R!==gr)&&(n.blendEquation(n.FUNC_ADD),y=gr,R=gr),Ot)switch(F){case So:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFunc(n.ONE,n.ONE);break;case Fd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ud:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",F);break}else switch(F){case So:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Fd:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ud:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",F);break}A=null,M=null,T=null,v=null,E.set(0,0,0),k=0,p=F,D=Ot}return}gt=gt||rt,Mt=Mt||it,Ht=Ht||wt,(rt!==y||gt!==R)&&(n.blendEquationSeparate(re[rt],re[gt]),y=rt,R=gt),(it!==A||wt!==M||Mt!==T||Ht!==v)&&(n.blendFuncSeparate(te[it],te[wt],te[Mt],te[Ht]),A=it,M=wt,T=Mt,v=Ht),(Zt.equals(E)===!1||ct!==k)&&(n.blendColor(Zt.r,Zt.g,Zt.b,ct),E.copy(Zt),k=ct),p=F,D=!1}function Ue(F,rt){F.side===Mn?Gt(n.CULL_FACE):St(n.CULL_FACE);let it=F.side===Xi;rt&&(it=!it),oi(it),F.blending===So&&F.transparent===!1?We(xs):We(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let wt=F.stencilWrite;a.setTest(wt),wt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),ve(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?St(n.SAMPLE_ALPHA_TO_COVERAGE):Gt(n.SAMPLE_ALPHA_TO_COVERAGE)}function oi(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Ce(F){F!==Hg?(St(n.CULL_FACE),F!==G&&(F===Nd?n.cullFace(n.BACK):F===Gg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Gt(n.CULL_FACE),G=F}function wi(F){F!==W&&(O&&n.lineWidth(F),W=F)}function ve(F,rt,it){F?(St(n.POLYGON_OFFSET_FILL),(N!==rt||V!==it)&&(N=rt,V=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):Gt(n.POLYGON_OFFSET_FILL)}function gi(F){F?St(n.SCISSOR_TEST):Gt(n.SCISSOR_TEST)}function je(F){F===void 0&&(F=n.TEXTURE0+X-1),Q!==F&&(n.activeTexture(F),Q=F)}function ai(F,rt,it){it===void 0&&(Q===null?it=n.TEXTURE0+X-1:it=Q);let wt=st[it];wt===void 0&&(wt={type:void 0,texture:void 0},st[it]=wt),(wt.type!==F||wt.texture!==rt)&&(Q!==it&&(n.activeTexture(it),Q=it),n.bindTexture(F,rt||At[F]),wt.type=F,wt.texture=rt)}function U(){let F=st[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ct(){try{n.compressedTexImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function $t(){try{n.compressedTexImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ne(){try{n.texSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function bt(){try{n.texSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Le(){try{n.compressedTexSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Xt(){try{n.texStorage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function C(){try{n.texStorage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function $(){try{n.texImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ht(F){return u[F]!==void 0?u[F]:n.getParameter(F)}function ot(F,rt){u[F]!==rt&&(n.pixelStorei(F,rt),u[F]=rt)}function _t(F){tt.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){mt.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),mt.copy(F))}function et(F,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let wt=it.get(F);wt===void 0&&(wt=n.getUniformBlockIndex(rt,F.name),n.uniformBlockBinding(rt,wt,wt),it.set(F,wt))}function nt(F,rt,it){let gt=c.get(rt).get(F);l[gt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,gt,it),l[gt]=it)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),d={},u={},Q=null,st={},h={},l={},f=new WeakMap,g=[],_=null,m=!1,p=null,y=null,A=null,M=null,R=null,T=null,v=null,E=new _e(0,0,0),k=0,D=!1,L=null,G=null,W=null,N=null,V=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Gt,bindFramebuffer:ie,drawBuffers:Vt,useProgram:ce,setBlending:We,setMaterial:Ue,setFlipSided:oi,setCullFace:Ce,setLineWidth:wi,setPolygonOffset:ve,setScissorTest:gi,activeTexture:je,bindTexture:ai,unbindTexture:U,compressedTexImage2D:Ct,compressedTexImage3D:$t,texImage2D:S,texImage3D:$,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:nt,texStorage2D:Xt,texStorage3D:C,texSubImage2D:ne,texSubImage3D:bt,compressedTexSubImage2D:Le,compressedTexSubImage3D:zt,scissor:_t,viewport:vt,reset:pt}}function iT(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ge,d=new WeakMap,u=new Set,h,f=new WeakMap,g=new Set,_=new FinalizationRegistry(C=>g.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,S){return m?new OffscreenCanvas(C,S):ua("canvas")}function y(C,S,$){let ht=1,ot=Xt(C);if((ot.width>$||ot.height>$)&&(ht=$/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let _t=Math.floor(ht*ot.width),vt=Math.floor(ht*ot.height);h===void 0&&(h=p(_t,vt));let et=S?p(_t,vt):h;return et.width=_t,et.height=vt,et.getContext("2d").drawImage(C,0,0,_t,vt),Yt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+vt+")."),et}else return"data"in C&&Yt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),C;return C}function A(C){return C.generateMipmaps}function M(C){n.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(C,S,$,ht,ot,_t=!1){if(C!==null){if(n[C]!==void 0)return n[C];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let vt;ht&&(vt=t.get("EXT_texture_norm16"),vt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=S;if(S===n.RED&&($===n.FLOAT&&(et=n.R32F),$===n.HALF_FLOAT&&(et=n.R16F),$===n.UNSIGNED_BYTE&&(et=n.R8),$===n.UNSIGNED_SHORT&&vt&&(et=vt.R16_EXT),$===n.SHORT&&vt&&(et=vt.R16_SNORM_EXT)),S===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.R8UI),$===n.UNSIGNED_SHORT&&(et=n.R16UI),$===n.UNSIGNED_INT&&(et=n.R32UI),$===n.BYTE&&(et=n.R8I),$===n.SHORT&&(et=n.R16I),$===n.INT&&(et=n.R32I)),S===n.RG&&($===n.FLOAT&&(et=n.RG32F),$===n.HALF_FLOAT&&(et=n.RG16F),$===n.UNSIGNED_BYTE&&(et=n.RG8),$===n.UNSIGNED_SHORT&&vt&&(et=vt.RG16_EXT),$===n.SHORT&&vt&&(et=vt.RG16_SNORM_EXT)),S===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RG8UI),$===n.UNSIGNED_SHORT&&(et=n.RG16UI),$===n.UNSIGNED_INT&&(et=n.RG32UI),$===n.BYTE&&(et=n.RG8I),$===n.SHORT&&(et=n.RG16I),$===n.INT&&(et=n.RG32I)),S===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGB8UI),$===n.UNSIGNED_SHORT&&(et=n.RGB16UI),$===n.UNSIGNED_INT&&(et=n.RGB32UI),$===n.BYTE&&(et=n.RGB8I),$===n.SHORT&&(et=n.RGB16I),$===n.INT&&(et=n.RGB32I)),S===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),$===n.UNSIGNED_INT&&(et=n.RGBA32UI),$===n.BYTE&&(et=n.RGBA8I),$===n.SHORT&&(et=n.RGBA16I),$===n.INT&&(et=n.RGBA32I)),S===n.RGB&&($===n.UNSIGNED_SHORT&&vt&&(et=vt.RGB16_EXT),$===n.SHORT&&vt&&(et=vt.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),S===n.RGBA){let nt=_t?ca:me.getTransfer(ot);$===n.FLOAT&&(et=n.RGBA32F),$===n.HALF_FLOAT&&(et=n.RGBA16F),$===n.UNSIGNED_BYTE&&(et=nt===Ee?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&vt&&(et=vt.RGBA16_EXT),$===n.SHORT&&vt&&(et=vt.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function v(C,S){let $;return C?S===null||S===Fn||S===xr?$=n.DEPTH24_STENCIL8:S===$i?$=n.DEPTH32F_STENCIL8:S===wo&&($=n.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Fn||S===xr?$=n.DEPTH_COMPONENT24:S===$i?$=n.DEPTH_COMPONENT32F:S===wo&&($=n.DEPTH_COMPONENT16),$}function E(C,S){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==pi&&C.minFilter!==Pi?Math.log2(Math.max(S.width,S.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?S.mipmaps.length:1}function k(C){let S=new WeakRef(C);i.get(C).__ref=S,g.add(S),_.register(C,S,S)}function D(C){let S=i.get(C).__ref;S!==void 0&&(g.delete(S),_.unregister(S))}function L(C){W(C.target)}function G(C){N(C.target)}function W(C){C.removeEventListener("dispose",L),D(C),X(C),C.isVideoTexture&&d.delete(C),C.isHTMLTexture&&u.delete(C)}function N(C){C.removeEventListener("dispose",G),D(C),lt(C)}function V(){for(let C of g){let S=C.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):W(S))}g.clear(),u.clear()}function X(C){let S=i.get(C);if(S.__webglInit===void 0)return;let $=C.source,ht=f.get($);if(ht){let ot=ht[S.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&O(C),Object.keys(ht).length===0&&f.delete($)}i.remove(C)}function O(C){let S=i.get(C);n.deleteTexture(S.__webglTexture);let $=C.source,ht=f.get($);delete ht[S.__cacheKey],o.memory.textures--}function lt(C){let S=i.get(C);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=C.depthTexture;if($&&$.renderTarget===C&&W($),C.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(S.__webglFramebuffer[ot]))for(let _t=0;_t<S.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(S.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(S.__webglFramebuffer[ot]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ot])}else{if(Array.isArray(S.__webglFramebuffer))for(let ot=0;ot<S.__webglFramebuffer.length;ot++)n.deleteFramebuffer(S.__webglFramebuffer[ot]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ot=0;ot<S.__webglColorRenderbuffer.length;ot++)S.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ot]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ht=C.textures;for(let ot=0,_t=ht.length;ot<_t;ot++){let vt=i.get(ht[ot]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(C)}let Z=0;function Q(){Z=0}function st(){return Z}function dt(C){Z=C}function ut(){let C=Z;return C>=s.maxTextures&&Yt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,C}function tt(C){let S=[];return S.push(C.wrapS),S.push(C.wrapT),S.push(C.wrapR||0),S.push(C.magFilter),S.push(C.minFilter),S.push(C.anisotropy),S.push(C.internalFormat),S.push(C.format),S.push(C.type),S.push(C.generateMipmaps),S.push(C.mipmapsAutoUpdate),S.push(C.premultiplyAlpha),S.push(C.flipY),S.push(C.unpackAlignment),S.push(C.colorSpace),S.join()}function mt(C,S){let $=i.get(C);if(C.isVideoTexture&&Le(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&$.__version!==C.version){let ht=C.image;if(ht===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ue($,C,S);return}}else C.isExternalTexture&&($.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+S)}function xt(C,S){let $=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&$.__version!==C.version){Ue($,C,S);return}else C.isExternalTexture&&($.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+S)}function At(C,S){let $=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&$.__version!==C.version){Ue($,C,S);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+S)}function St(C,S){let $=i.get(C);if(C.version>0&&$.__version!==C.version){oi($,C,S);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+S)}let Gt={[Ec]:n.REPEAT,[Yn]:n.CLAMP_TO_EDGE,[Tc]:n.MIRRORED_REPEAT},ie={[pi]:n.NEAREST,[l0]:n.NEAREST_MIPMAP_NEAREST,[wa]:n.NEAREST_MIPMAP_LINEAR,[Pi]:n.LINEAR,[Qc]:n.LINEAR_MIPMAP_NEAREST,[vs]:n.LINEAR_MIPMAP_LINEAR},Vt={[d0]:n.NEVER,[rf]:n.ALWAYS,[f0]:n.LESS,[nf]:n.LEQUAL,[p0]:n.EQUAL,[sf]:n.GEQUAL,[m0]:n.GREATER,[g0]:n.NOTEQUAL};function ce(C,S){if(S.type===$i&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Pi||S.magFilter===Qc||S.magFilter===wa||S.magFilter===vs||S.minFilter===Pi||S.minFilter===Qc||S.minFilter===wa||S.minFilter===vs)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,Gt[S.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,Gt[S.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,Gt[S.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,ie[S.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,ie[S.minFilter]),S.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Vt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===pi||S.minFilter!==wa&&S.minFilter!==vs||S.type===$i&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(C,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function re(C,S){let $=!1;C.__webglInit===void 0&&(C.__webglInit=!0,S.addEventListener("dispose",L),k(S));let ht=S.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let _t=tt(S);if(_t!==C.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ot[_t].usedTimes++;let vt=ot[C.__cacheKey];vt!==void 0&&(ot[C.__cacheKey].usedTimes--,vt.usedTimes===0&&O(S)),C.__cacheKey=_t,C.__webglTexture=ot[_t].texture}return $}function te(C,S,$){return Math.floor(Math.floor(C/$)/S)}function We(C,S,$,ht){let _t=C.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,$,ht,S.data);else{_t.sort((F,rt)=>F.start-rt.start);let vt=0;for(let F=1;F<_t.length;F++){let rt=_t[vt],it=_t[F],wt=rt.start+rt.count,gt=te(it.start,S.width,4),Mt=te(rt.start,S.width,4);it.start<=wt+1&&gt===Mt&&te(it.start+it.count-1,S.width,4)===gt?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,_t[vt]=it)}_t.length=vt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),nt=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,rt=_t.length;F<rt;F++){let it=_t[F],wt=Math.floor(it.start/4),gt=Math.ceil(it.count/4),Mt=wt%S.width,Ht=Math.floor(wt/S.width),Zt=gt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,Mt,Ht,Zt,ct,$,ht,S.data)}C.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,nt),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function Ue(C,S,$){let ht=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=re(C,S),_t=S.source;e.bindTexture(ht,C.__webglTexture,n.TEXTURE0+$);let vt=i.get(_t);if(_t.version!==vt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ct=me.getPrimaries(me.workingColorSpace),Ot=S.colorSpace===Ms?null:me.getPrimaries(S.colorSpace),Kt=S.colorSpace===Ms||ct===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let nt=y(S.image,!1,s.maxTextureSize);nt=zt(S,nt);let pt=r.convert(S.format,S.colorSpace),F=r.convert(S.type),rt=T(S.internalFormat,pt,F,S.normalized,S.colorSpace,S.isVideoTexture);ce(ht,S);let it,wt=S.mipmaps,gt=S.isVideoTexture!==!0,Mt=vt.__version===void 0||ot===!0,Ht=_t.dataReady,Zt=E(S,nt);if(S.isDepthTexture)rt=v(S.format===ys,S.type),Mt&&(gt?e.texStorage2D(n.TEXTURE_2D,1,rt,nt.width,nt.height):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,null));else if(S.isDataTexture)if(wt.length>0){gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let ct=0,Ot=wt.length;ct<Ot;ct++)it=wt[ct],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,F,it.data);S.generateMipmaps=!1}else gt?(Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height),Ht&&We(S,nt,pt,F)):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,nt.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){gt&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,wt[0].width,wt[0].height,nt.depth);for(let ct=0,Ot=wt.length;ct<Ot;ct++)if(it=wt[ct],S.format!==qi)if(pt!==null)if(gt){if(Ht)if(S.layerUpdates.size>0){let Kt=uf(it.width,it.height,S.format,S.type);for(let Rt of S.layerUpdates){let se=it.data.subarray(Rt*Kt/it.data.BYTES_PER_ELEMENT,(Rt+1)*Kt/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Rt,it.width,it.height,1,pt,se)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,nt.depth,pt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,nt.depth,0,it.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,nt.depth,pt,F,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,nt.depth,0,pt,F,it.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let ct=0,Ot=wt.length;ct<Ot;ct++)it=wt[ct],S.format!==qi?pt!==null?gt?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,it.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,F,it.data)}else if(S.isDataArrayTexture)if(gt){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,nt.width,nt.height,nt.depth),Ht)if(S.layerUpdates.size>0){let ct=uf(nt.width,nt.height,S.format,S.type);for(let Ot of S.layerUpdates){let Kt=nt.data.subarray(Ot*ct/nt.data.BYTES_PER_ELEMENT,(Ot+1)*ct/nt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,nt.width,nt.height,1,pt,F,Kt)}S.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(S.isData3DTexture)gt?(Mt&&e.texStorage3D(n.TEXTURE_3D,Zt,rt,nt.width,nt.height,nt.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)):e.texImage3D(n.TEXTURE_3D,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(S.isFramebufferTexture){if(Mt)if(gt)e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height);else{let ct=nt.width,Ot=nt.height;for(let Kt=0;Kt<Zt;Kt++)e.texImage2D(n.TEXTURE_2D,Kt,rt,ct,Ot,0,pt,F,null),ct>>=1,Ot>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),nt.parentNode!==ct){ct.appendChild(nt),u.add(S),ct.onpaint=Ot=>{let Kt=Ot.changedElements;for(let Rt of u)Kt.includes(Rt.image)&&(Rt.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,nt);else{let Kt=n.RGBA,Rt=n.RGBA,se=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Kt,Rt,se,nt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&Mt){let ct=Xt(wt[0]);e.texStorage2D(n.TEXTURE_2D,Zt,rt,ct.width,ct.height)}for(let ct=0,Ot=wt.length;ct<Ot;ct++)it=wt[ct],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,pt,F,it):e.texImage2D(n.TEXTURE_2D,ct,rt,pt,F,it);S.generateMipmaps=!1}else if(gt){if(Mt){let ct=Xt(nt);e.texStorage2D(n.TEXTURE_2D,Zt,rt,ct.width,ct.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,F,nt)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,F,nt);A(S)&&S.mipmapsAutoUpdate===!0&&M(ht),vt.__version=_t.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function oi(C,S,$){if(S.image.length!==6)return;let ht=re(C,S),ot=S.source;e.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+$);let _t=i.get(ot);if(ot.version!==_t.__version||ht===!0){e.activeTexture(n.TEXTURE0+$);let vt=me.getPrimaries(me.workingColorSpace),et=S.colorSpace===Ms?null:me.getPrimaries(S.colorSpace),nt=S.colorSpace===Ms||vt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt);let pt=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!F?rt[Rt]=y(S.image[Rt],!0,s.maxCubemapSize):rt[Rt]=F?S.image[Rt].image:S.image[Rt],rt[Rt]=zt(S,rt[Rt]);let it=rt[0],wt=r.convert(S.format,S.colorSpace),gt=r.convert(S.type),Mt=T(S.internalFormat,wt,gt,S.normalized,S.colorSpace),Ht=S.isVideoTexture!==!0,Zt=_t.__version===void 0||ht===!0,ct=ot.dataReady,Ot=E(S,it);ce(n.TEXTURE_CUBE_MAP,S);let Kt;if(S.isDepthTexture){if(Mt=v(S.format===ys,S.type),Zt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,it.width,it.height,0,wt,gt,null)}else if(pt){Ht&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){Kt=rt[Rt].mipmaps;for(let se=0;se<Kt.length;se++){let ke=Kt[se];S.format!==qi?wt!==null?Ht?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,ke.width,ke.height,wt,ke.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,ke.width,ke.height,0,ke.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,ke.width,ke.height,wt,gt,ke.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,ke.width,ke.height,0,wt,gt,ke.data)}}}else{if(Kt=S.mipmaps,Ht&&Zt){Kt.length>0&&Ot++;let Rt=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,wt,gt,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,rt[Rt].width,rt[Rt].height,0,wt,gt,rt[Rt].data);for(let se=0;se<Kt.length;se++){let ki=Kt[se].image[Rt].image;Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,ki.width,ki.height,wt,gt,ki.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,ki.width,ki.height,0,wt,gt,ki.data)}}else{Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,wt,gt,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,wt,gt,rt[Rt]);for(let se=0;se<Kt.length;se++){let ke=Kt[se];Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,wt,gt,ke.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,wt,gt,ke.image[Rt])}}}A(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,S.onUpdate&&S.onUpdate(S)}C.__version=S.version}function Ce(C,S,$,ht,ot,_t){let vt=r.convert($.format,$.colorSpace),et=r.convert($.type),nt=T($.internalFormat,vt,et,$.normalized,$.colorSpace),pt=i.get(S),F=i.get($);if(F.__renderTarget=S,!pt.__hasExternalTextures){let rt=Math.max(1,S.width>>_t),it=Math.max(1,S.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,nt,rt,it,S.depth,0,vt,et,null):e.texImage2D(ot,_t,nt,rt,it,0,vt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,C),bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,F.__webglTexture,0,ne(S)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,F.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function wi(C,S,$){if(n.bindRenderbuffer(n.RENDERBUFFER,C),S.depthBuffer){let ht=S.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,_t=v(S.stencilBuffer,ot),vt=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(S),_t,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(S),_t,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,_t,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,C)}else{let ht=S.textures;for(let ot=0;ot<ht.length;ot++){let _t=ht[ot],vt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),nt=T(_t.internalFormat,vt,et,_t.normalized,_t.colorSpace);bt(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(S),nt,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(S),nt,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,nt,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(C,S,$){let ht=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,C),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(S.depthTexture);ot.__renderTarget=S;let _t=ht?S.depthTexture.image[0]:S.depthTexture.image;(!ot.__webglTexture||_t.width!==S.width||_t.height!==S.height)&&(_t.width=S.width,_t.height=S.height,S.depthTexture.needsUpdate=!0),ht?St(S.depthTexture,0):mt(S.depthTexture,0);let vt=ot.__webglTexture,et=ne(S),nt=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,pt=S.depthTexture.format===ys?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===ms)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else if(S.depthTexture.format===ys)bt(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gi(C){let S=i.get(C),$=C.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==C.depthTexture){let ht=C.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ht){let ot=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),S.__depthDisposeCallback=ot}S.__boundDepthTexture=ht}if(C.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let ht=0;ht<6;ht++)ve(S.__webglFramebuffer[ht],C,ht);else C.texture.mipmaps.length>0?ve(S.__webglFramebuffer[0],C,0):ve(S.__webglFramebuffer,C,0);else if($){S.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ht]),S.__webglDepthbuffer[ht]===void 0)S.__webglDepthbuffer[ht]=n.createRenderbuffer(),wi(S.__webglDepthbuffer[ht],C,!1);else{let ot=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),wi(S.__webglDepthbuffer,C,!1);else{let ot=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function je(C,S,$){let ht=i.get(C);S!==void 0&&Ce(ht.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&gi(C)}function ai(C){let S=C.texture,$=i.get(C),ht=i.get(S);C.addEventListener("dispose",G),k(C);let ot=C.textures,_t=C.isWebGLCubeRenderTarget===!0,vt=ot.length>1;if(vt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=S.version,o.memory.textures++),_t){$.__webglFramebuffer=[];for(let et=0;et<6;et++)if(S.mipmaps.length>0){$.__webglFramebuffer[et]=[];for(let nt=0;nt<S.mipmaps.length;nt++)$.__webglFramebuffer[et][nt]=n.createFramebuffer()}else $.__webglFramebuffer[et]=n.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let et=0;et<S.mipmaps.length;et++)$.__webglFramebuffer[et]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(vt)for(let et=0,nt=ot.length;et<nt;et++){let pt=i.get(ot[et]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(C.samples>0&&bt(C)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let nt=ot[et];$.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[et]);let pt=r.convert(nt.format,nt.colorSpace),F=r.convert(nt.type),rt=T(nt.internalFormat,pt,F,nt.normalized,nt.colorSpace,C.isXRRenderTarget===!0),it=ne(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,$.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),wi($.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),ce(n.TEXTURE_CUBE_MAP,S);for(let et=0;et<6;et++)if(S.mipmaps.length>0)for(let nt=0;nt<S.mipmaps.length;nt++)Ce($.__webglFramebuffer[et][nt],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,nt);else Ce($.__webglFramebuffer[et],C,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);A(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let et=0,nt=ot.length;et<nt;et++){let pt=ot[et],F=i.get(pt),rt=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(rt=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),ce(rt,pt),Ce($.__webglFramebuffer,C,pt,n.COLOR_ATTACHMENT0+et,rt,0),A(pt)&&M(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(et=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),ce(et,S),S.mipmaps.length>0)for(let nt=0;nt<S.mipmaps.length;nt++)Ce($.__webglFramebuffer[nt],C,S,n.COLOR_ATTACHMENT0,et,nt);else Ce($.__webglFramebuffer,C,S,n.COLOR_ATTACHMENT0,et,0);A(S)?M(et):S.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&gi(C)}function U(C){let S=C.textures;for(let $=0,ht=S.length;$<ht;$++){let ot=S[$];if(A(ot)&&ot.mipmapsAutoUpdate===!0){let _t=R(C),vt=i.get(ot).__webglTexture;e.bindTexture(_t,vt),M(_t),e.unbindTexture()}}}let Ct=[];function $t(C){if(C.samples>0){if(bt(C)===!1){let S=C.textures,$=C.width,ht=C.height,ot=n.COLOR_BUFFER_BIT,_t=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(C),et=S.length>1;if(et)for(let pt=0;pt<S.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<S.length;pt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(S[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,$,ht,0,0,$,ht,ot,n.NEAREST),l===!0&&(Ct.length=0,Ct.push(n.COLOR_ATTACHMENT0+pt),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ct.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let pt=0;pt<S.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(S[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,F,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let S=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ne(C){return Math.min(s.maxSamples,C.samples)}function bt(C){let S=i.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Le(C){let S=o.render.frame;d.get(C)!==S&&(d.set(C,S),C.update())}function zt(C,S){let $=C.colorSpace,ht=C.format,ot=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||$!==ks&&$!==Ms&&(me.getTransfer($)===Ee?(ht!==qi||ot!==dn)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",$)),S}function Xt(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=St,this.rebindTextures=je,this.setupRenderTarget=ai,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=$t,this.setupDepthRenderbuffer=gi,this.setupFrameBufferTexture=Ce,this.useMultisampledRTT=bt,this.dispose=V}function nT(n,t){function e(i,s=Ms){let r,o=me.getTransfer(s);if(i===dn)return n.UNSIGNED_BYTE;if(i===eh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ih)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Kd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Jd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Yd)return n.BYTE;if(i===Zd)return n.SHORT;if(i===wo)return n.UNSIGNED_SHORT;if(i===th)return n.INT;if(i===Fn)return n.UNSIGNED_INT;if(i===$i)return n.FLOAT;if(i===Un)return n.HALF_FLOAT;if(i===jd)return n.ALPHA;if(i===Qd)return n.RGB;if(i===qi)return n.RGBA;if(i===ms)return n.DEPTH_COMPONENT;if(i===ys)return n.DEPTH_STENCIL;if(i===tf)return n.RED;if(i===nh)return n.RED_INTEGER;if(i===$s)return n.RG;if(i===sh)return n.RG_INTEGER;if(i===rh)return n.RGBA_INTEGER;if(i===Ea||i===Ta||i===Aa||i===Ra)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ea)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ea)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===oh||i===ah||i===lh||i===ch)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===oh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ah)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===lh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ch)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===hh||i===uh||i===dh||i===fh||i===ph||i===Ca||i===mh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===hh||i===uh)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===dh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===fh)return r.COMPRESSED_R11_EAC;if(i===ph)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ca)return r.COMPRESSED_RG11_EAC;if(i===mh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===gh||i===_h||i===xh||i===vh||i===yh||i===Mh||i===Sh||i===bh||i===wh||i===Eh||i===Th||i===Ah||i===Rh||i===Ch)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===gh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===_h)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===xh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===vh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===yh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Mh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Sh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===bh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===wh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Eh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Th)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ah)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Rh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ch)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ph||i===Ih||i===Lh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ph)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ih)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Lh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nh||i===Dh||i===Pa||i===Fh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Nh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Dh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Pa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Fh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===xr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var sT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,rT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,yf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new va(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Jn({vertexShader:sT,fragmentShader:rT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Mi(new ya(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Mf=class extends Zn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,d=null,u=null,h=null,f=null,g=null,_=typeof XRWebGLBinding<"u",m=new yf,p={},y=e.getContextAttributes(),A=null,M=null,R=[],T=[],v=new ge,E=null,k=null,D=new cn;D.viewport=new Je;let L=new cn;L.viewport=new Je;let G=[D,L],W=new Yc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=R[tt];return mt===void 0&&(mt=new _o,R[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=R[tt];return mt===void 0&&(mt=new _o,R[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=R[tt];return mt===void 0&&(mt=new _o,R[tt]=mt),mt.getHandSpace()};function X(tt){let mt=T.indexOf(tt.inputSource);if(mt===-1)return;let xt=R[mt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function O(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<R.length;tt++){let mt=T[tt];mt!==null&&(T[tt]=null,R[tt].disconnect(mt))}N=null,V=null,m.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(A),f=null,h=null,u=null,s=null,M=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(v.width,v.height,!1),k!==null){let tt=k.camera;tt.fov=k.fov,tt.zoom=k.zoom,tt.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",O),s.addEventListener("inputsourceschange",lt),y.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(v),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,St=null;y.depth&&(St=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?ys:ms,At=y.stencil?xr:Fn);let Gt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};u=this.getBinding(),h=u.createProjectionLayer(Gt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),M=new Wi(h.textureWidth,h.textureHeight,{format:qi,type:dn,depthTexture:new _s(h.textureWidth,h.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new Wi(f.framebufferWidth,f.framebufferHeight,{format:qi,type:dn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function lt(tt){for(let mt=0;mt<tt.removed.length;mt++){let xt=tt.removed[mt],At=T.indexOf(xt);At>=0&&(T[At]=null,R[At].disconnect(xt))}for(let mt=0;mt<tt.added.length;mt++){let xt=tt.added[mt],At=T.indexOf(xt);if(At===-1){for(let Gt=0;Gt<R.length;Gt++)if(Gt>=T.length){T.push(xt),At=Gt;break}else if(T[Gt]===null){T[Gt]=xt,At=Gt;break}if(At===-1)break}let St=R[At];St&&St.connect(xt)}}function Z(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,xt=tt.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),W.near=L.near=D.near=mt,W.far=L.far=D.far=xt,(N!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,V=W.far),W.layers.mask=tt.layers.mask|6,D.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;let At=tt.parent,St=W.cameras;Z(W,At);for(let Gt=0;Gt<St.length;Gt++)Z(St[Gt],At);W.projectionMatrix.copy(D.projectionMatrix),W.projectionMatrixInverse.copy(D.projectionMatrixInverse),k===null&&tt.isPerspectiveCamera&&(k={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,W,At)};function Q(tt,mt,xt){xt===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Rc*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(tt){l=tt,h!==null&&(h.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(tt){return p[tt]};let st=null;function dt(tt,mt){if(d=mt.getViewerPose(c||o),g=mt,d!==null){let xt=d.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let At=!1;xt.length!==W.cameras.length&&(W.cameras.length=0,At=!0);for(let Vt=0;Vt<xt.length;Vt++){let ce=xt[Vt],re=null;if(f!==null)re=f.getViewport(ce);else{let We=u.getViewSubImage(h,ce);re=We.viewport,Vt===0&&(t.setRenderTargetTextures(M,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(M))}let te=G[Vt];te===void 0&&(te=new cn,te.layers.enable(Vt),te.viewport=new Je,G[Vt]=te),te.matrix.fromArray(ce.transform.matrix),te.matrix.decompose(te.position,te.quaternion,te.scale),te.projectionMatrix.fromArray(ce.projectionMatrix),te.projectionMatrixInverse.copy(te.projectionMatrix).invert(),te.viewport.set(re.x,re.y,re.width,re.height),Vt===0&&(W.matrix.copy(te.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),At===!0&&W.cameras.push(te)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=i.getBinding();let Vt=u.getDepthInformation(xt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(St&&St.includes("camera-access")&&_){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<xt.length;Vt++){let ce=xt[Vt].camera;if(ce){let re=p[ce];re||(re=new va,p[ce]=re);let te=u.getCameraImage(ce);re.sourceTexture=te}}}}for(let xt=0;xt<R.length;xt++){let At=T[xt],St=R[xt];At!==null&&St!==void 0&&St.update(At,mt,c||o)}st&&st(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let ut=new Y0;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},oT=new Oe,s_=new Qt;s_.set(-1,0,0,0,1,0,0,0,1);function aT(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,lf(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,A,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),d(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),h(m,p),p.isMeshPhysicalMaterial&&f(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),_(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Xi&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Xi&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let y=t.get(p),A=y.envMap,M=y.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(oT.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(s_),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=A*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function d(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function h(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,y){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Xi&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function _(m,p){let y=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function lT(n,t,e,i){let s={},r={};function o(y,A){let M=A.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,A){let M=s[y.id];M===void 0&&(g(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",m));let R=A.program;i.updateUBOMapping(y,R);let T=t.render.frame;r[y.id]!==T&&(c(y),r[y.id]=T)}function l(y){let A=n.createBuffer(),M=y.__size,R=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(y){let A=s[y.id],M=y.uniforms,R=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let T=0,v=M.length;T<v;T++){let E=M[T];if(Array.isArray(E))for(let k=0,D=E.length;k<D;k++)d(E[k],T,k,R);else d(E,T,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,A,M,R){if(h(y,A,M,R)===!0){let T=y.__offset,v=y.value;if(Array.isArray(v)){let E=0;for(let k=0;k<v.length;k++){let D=v[k],L=_(D,!0);u(D,y.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,y.__data)}}function u(y,A,M){typeof y=="number"||typeof y=="boolean"?A[M]=y:y.isMatrix3?(A[M]=y.elements[0],A[M+1]=y.elements[1],A[M+2]=y.elements[2],A[M+3]=0,A[M+4]=y.elements[3],A[M+5]=y.elements[4],A[M+6]=y.elements[5],A[M+7]=0,A[M+8]=y.elements[6],A[M+9]=y.elements[7],A[M+10]=y.elements[8],A[M+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-M),M):y.toArray(A,M)}function h(y,A,M,R){let T=y.value,v=A+"_"+M;if(Array.isArray(T)){R[v]===void 0&&(R[v]=[]);let E=R[v],k=!1;for(let D=0;D<T.length;D++)f(T[D],E,D)===!0&&(k=!0);return k}return f(T,R,v)}function f(y,A,M){if(A[M]===void 0)return typeof y=="number"||typeof y=="boolean"?A[M]=y:ArrayBuffer.isView(y)?A[M]=y.slice():A[M]=y.clone(),!0;{let R=A[M];if(typeof y=="number"||typeof y=="boolean"){if(R!==y)return A[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(R.equals(y)===!1)return R.copy(y),!0}}return!1}function g(y){let A=y.uniforms,M=0,R=16;for(let v=0,E=A.length;v<E;v++){let k=Array.isArray(A[v])?A[v]:[A[v]];for(let D=0,L=k.length;D<L;D++){let G=k[D],W=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(A[v])||Array.isArray(G.value),V=M;for(let O=0,lt=W.length;O<lt;O++){let Z=W[O],Q=_(Z,N),st=M%R,dt=st%Q.boundary,ut=st+dt;M+=dt,ut!==0&&R-ut<Q.storage&&(M+=R-ut),O===0&&(V=M),M+=Q.storage}let X=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new X((M-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let T=M%R;return T>0&&(M+=R-T),y.__size=M,y.__cache={},this}function _(y,A){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(y){let A=y.target;A.removeEventListener("dispose",m),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var cT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Qn=null;function hT(){return Qn===null&&(Qn=new gs(cT,16,16,$s,Un),Qn.name="DFG_LUT",Qn.minFilter=Pi,Qn.magFilter=Pi,Qn.wrapS=Yn,Qn.wrapT=Yn,Qn.generateMipmaps=!1,Qn.needsUpdate=!0),Qn}var Bh=class{constructor(t={}){let{canvas:e=x0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:h=!1,outputBufferType:f=dn}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=f,m=new Set([rh,sh,nh]),p=new Set([dn,Fn,wo,xr,eh,ih]),y=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,T=null,v=[],E=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=jn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,G=null,W=null,N=null,V=null;this._outputColorSpace=ln;let X=0,O=0,lt=null,Z=-1,Q=null,st=new Je,dt=new Je,ut=null,tt=new _e(0),mt=0,xt=e.width,At=e.height,St=1,Gt=null,ie=null,Vt=new Je(0,0,xt,At),ce=new Je(0,0,xt,At),re=!1,te=new fr,We=new Nc,Ue=!1,oi=!1,Ce=new Oe,wi=new J,ve=new Je,gi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},je=!1;function ai(){return lt===null?St:1}let U=i;function Ct(w,B){return e.getContext(w,B)}let $t,ne,bt,Le,zt,Xt,C,S,$,ht,ot,_t,vt,et,nt,pt,F,rt,it,wt,gt,Mt,Ht;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:d,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),U===null){let B="webgl2";if(U=Ct(B,w),U===null)throw Ct(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(w){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),jt("WebGLRenderer: "+w.message),w}function Zt(){$t=new M1(U),$t.init(),gt=new nT(U,$t),ne=new h1(U,$t,t,gt),bt=new eT(U,$t),ne.reversedDepthBuffer&&h&&bt.buffers.depth.setReversed(!0),W=U.createFramebuffer(),N=U.createFramebuffer(),V=U.createFramebuffer(),Le=new w1(U),zt=new VE,Xt=new iT(U,$t,bt,zt,ne,gt,Le),C=new y1(D),S=new TS(U),Mt=new l1(U,S),$=new S1(U,S,Le,Mt),ht=new T1(U,$,S,Mt,Le),rt=new E1(U,ne,Xt),nt=new u1(zt),ot=new zE(D,C,$t,ne,Mt,nt),_t=new aT(D,zt),vt=new GE,et=new ZE($t),F=new a1(D,C,bt,ht,g,l),pt=new tT(D,ht,ne),Ht=new lT(U,Le,ne,bt),it=new c1(U,$t,Le),wt=new b1(U,$t,Le),Le.programs=ot.programs,D.capabilities=ne,D.extensions=$t,D.properties=zt,D.renderLists=vt,D.shadowMap=pt,D.state=bt,D.info=Le}_!==dn&&(k=new R1(_,e.width,e.height,a,s,r));let ct=new Mf(D,U);this.xr=ct,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=$t.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=$t.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(w){w!==void 0&&(St=w,this.setSize(xt,At,!1))},this.getSize=function(w){return w.set(xt,At)},this.setSize=function(w,B,j=!0){if(ct.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,At=B,e.width=Math.floor(w*St),e.height=Math.floor(B*St),j===!0&&(e.style.width=w+"px",e.style.height=B+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,B)},this.getDrawingBufferSize=function(w){return w.set(xt*St,At*St).floor()},this.setDrawingBufferSize=function(w,B,j){xt=w,At=B,St=j,e.width=Math.floor(w*j),e.height=Math.floor(B*j),this.setViewport(0,0,w,B)},this.setEffects=function(w){if(_===dn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let B=0;B<w.length;B++)if(w[B].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Vt)},this.setViewport=function(w,B,j,q){w.isVector4?Vt.set(w.x,w.y,w.z,w.w):Vt.set(w,B,j,q),bt.viewport(st.copy(Vt).multiplyScalar(ai()).round())},this.getScissor=function(w){return w.copy(ce)},this.setScissor=function(w,B,j,q){w.isVector4?ce.set(w.x,w.y,w.z,w.w):ce.set(w,B,j,q),bt.scissor(dt.copy(ce).multiplyScalar(ai()).round())},this.getScissorTest=function(){return re},this.setScissorTest=function(w){bt.setScissorTest(re=w)},this.setOpaqueSort=function(w){Gt=w},this.setTransparentSort=function(w){ie=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,B=!0,j=!0){let q=0;if(w){let Y=!1;if(lt!==null){let Et=lt.texture.format;Y=m.has(Et)}if(Y){let Et=lt.texture.type,Pt=p.has(Et),Tt=F.getClearColor(),It=F.getClearAlpha(),Bt=Tt.r,Jt=Tt.g,he=Tt.b;Pt?(y[0]=Bt,y[1]=Jt,y[2]=he,y[3]=It,U.clearBufferuiv(U.COLOR,0,y)):(A[0]=Bt,A[1]=Jt,A[2]=he,A[3]=It,U.clearBufferiv(U.COLOR,0,A))}else q|=U.COLOR_BUFFER_BIT}B&&(q|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(q|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&U.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),G=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),vt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),C.dispose(),ht.dispose(),$.dispose(),Mt.dispose(),Ht.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",za),ct.removeEventListener("sessionend",kn),is.stop()};function Ot(w){w.preventDefault(),of("WebGLRenderer: Context Lost."),L=!0}function Kt(){of("WebGLRenderer: Context Restored."),L=!1;let w=Le.autoReset,B=pt.enabled,j=pt.autoUpdate,q=pt.needsUpdate,Y=pt.type;Zt(),Le.autoReset=w,pt.enabled=B,pt.autoUpdate=j,pt.needsUpdate=q,pt.type=Y}function Rt(w){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function se(w){let B=w.target;B.removeEventListener("dispose",se),ke(B)}function ke(w){ki(w),zt.remove(w)}function ki(w){let B=zt.get(w).programs;B!==void 0&&(B.forEach(function(j){ot.releaseProgram(j)}),w.isShaderMaterial&&ot.releaseShaderCache(w))}this.renderBufferDirect=function(w,B,j,q,Y,Et){B===null&&(B=gi);let Pt=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Tt=Io(w,B,j,q,Y);bt.setMaterial(q,Pt);let It=j.index,Bt=1;if(q.wireframe===!0){if(It=$.getWireframeAttribute(j),It===void 0)return;Bt=2}let Jt=j.drawRange,he=j.attributes.position,kt=Jt.start*Bt,ue=(Jt.start+Jt.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),ue=Math.min(ue,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),ue=Math.min(ue,It.count)):he!=null&&(kt=Math.max(kt,0),ue=Math.min(ue,he.count));let Ye=ue-kt;if(Ye<0||Ye===1/0)return;Mt.setup(Y,q,Tt,j,It);let Te,Ae=it;if(It!==null&&(Te=S.get(It),Ae=wt,Ae.setIndex(Te)),Y.isMesh)q.wireframe===!0?(bt.setLineWidth(q.wireframeLinewidth*ai()),Ae.setMode(U.LINES)):Ae.setMode(U.TRIANGLES);else if(Y.isLine){let _i=q.linewidth;_i===void 0&&(_i=1),bt.setLineWidth(_i*ai()),Y.isLineSegments?Ae.setMode(U.LINES):Y.isLineLoop?Ae.setMode(U.LINE_LOOP):Ae.setMode(U.LINE_STRIP)}else Y.isPoints?Ae.setMode(U.POINTS):Y.isSprite&&Ae.setMode(U.TRIANGLES);if(Y.isBatchedMesh)if($t.get("WEBGL_multi_draw"))Ae.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let _i=Y._multiDrawStarts,Ft=Y._multiDrawCounts,li=Y._multiDrawCount,fe=It?S.get(It).bytesPerElement:1,ss=zt.get(q).currentProgram.getUniforms();for(let ci=0;ci<li;ci++)ss.setValue(U,"_gl_DrawID",ci),Ae.render(_i[ci]/fe,Ft[ci])}else if(Y.isInstancedMesh)Ae.renderInstances(kt,Ye,Y.count);else if(j.isInstancedBufferGeometry){let _i=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ft=Math.min(j.instanceCount,_i);Ae.renderInstances(kt,Ye,Ft)}else Ae.render(kt,Ye)};function Ro(w,B,j,q){G!==null&&w.isNodeMaterial&&G.setObject(q,w),Ue===!0&&nt.setState(w,j,!1),w.transparent===!0&&w.side===Mn&&w.forceSinglePass===!1?(w.side=Xi,w.needsUpdate=!0,Bn(w,B,q),w.side=Xs,w.needsUpdate=!0,Bn(w,B,q),w.side=Mn):Bn(w,B,q)}this.compile=function(w,B,j=null){j===null&&(j=w),G!==null&&G.renderStart(w,B,j),T=et.get(j),T.init(B),E.push(T),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(B.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),w!==j&&w.traverseVisible(function(Y){Y.isLight&&Y.layers.test(B.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),oi=this.localClippingEnabled,Ue=nt.init(this.clippingPlanes,oi),Ue===!0&&nt.setGlobalState(this.clippingPlanes,B),G!==null&&pt.render(T.state.shadowsArray,j,B);let q=new Set;return w.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Et=Y.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];Ro(Tt,j,B,Y),q.add(Tt)}else Ro(Et,j,B,Y),q.add(Et)}),T=E.pop(),G!==null&&G.renderEnd(),q},this.compileAsync=function(w,B,j=null){let q=this.compile(w,B,j);return new Promise(Y=>{function Et(){if(q.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&q.delete(Pt)}),q.size===0){Y(w);return}setTimeout(Et,10)}$t.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Sr=null;function Jh(w){Sr&&Sr(w)}function za(){is.stop()}function kn(){is.start()}let is=new Y0;is.setAnimationLoop(Jh),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(w){Sr=w,ct.setAnimationLoop(w),w===null?is.stop():is.start()},ct.addEventListener("sessionstart",za),ct.addEventListener("sessionend",kn),this.render=function(w,B){if(B!==void 0&&B.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(w,B);let j=ct.enabled===!0&&ct.isPresenting===!0,q=k!==null&&(lt===null||j)&&k.begin(D,lt);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(B),B=ct.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,B,lt),T=et.get(w,E.length),T.init(B),T.state.textureUnits=Xt.getTextureUnits(),E.push(T),Ce.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?We.setFromArrayCamera(B):te.setFromProjectionMatrix(Ce,vn,B.reversedDepth),oi=this.localClippingEnabled,Ue=nt.init(this.clippingPlanes,oi),R=vt.get(w,v.length),R.init(),v.push(R),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=D.xr.getDepthSensingMesh();Pt!==null&&ns(Pt,B,-1/0,D.sortObjects)}ns(w,B,0,D.sortObjects),R.finish(),G!==null&&G.updateLights(T.state.lightsArray),D.sortObjects===!0&&R.sort(Gt,ie),je=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,je&&F.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Ue===!0&&nt.beginShadows();let Y=T.state.shadowsArray;if(pt.render(Y,w,B),Ue===!0&&nt.endShadows(),(q&&k.hasRenderPass())===!1){let Pt=R.opaque,Tt=R.transmissive;if(T.setupLights(),B.isArrayCamera){let It=B.cameras;if(Tt.length>0)for(let Bt=0,Jt=It.length;Bt<Jt;Bt++){let he=It[Bt];Sn(Pt,Tt,w,he)}je&&F.render(w);for(let Bt=0,Jt=It.length;Bt<Jt;Bt++){let he=It[Bt];Co(R,w,he,he.viewport)}}else Tt.length>0&&Sn(Pt,Tt,w,B),je&&F.render(w),Co(R,w,B)}lt!==null&&O===0&&(Xt.updateMultisampleRenderTarget(lt),Xt.updateRenderTargetMipmap(lt)),q&&k.end(D),w.isScene===!0&&w.onAfterRender(D,w,B),Mt.resetDefaultState(),Z=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],Xt.setTextureUnits(T.state.textureUnits),Ue===!0&&nt.setGlobalState(D.clippingPlanes,T.state.camera)):T=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,G!==null&&G.renderEnd()};function ns(w,B,j,q){if(w.visible===!1)return;if(w.layers.test(B.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(B);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){let Pt=B.isArrayCamera?We:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){q&&ve.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ce);let Tt=ht.update(w),It=w.material;It.visible&&R.push(w,Tt,It,j,ve.z,null,B)}}else if(w.isMesh||w.isLine||w.isPoints){let Pt=B.isArrayCamera?We:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){let Tt=ht.update(w),It=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),ve.copy(w.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ve.copy(Tt.boundingSphere.center)),ve.applyMatrix4(w.matrixWorld).applyMatrix4(Ce)),Array.isArray(It)){let Bt=Tt.groups;for(let Jt=0,he=Bt.length;Jt<he;Jt++){let kt=Bt[Jt],ue=It[kt.materialIndex];ue&&ue.visible&&R.push(w,Tt,ue,j,ve.z,kt,B)}}else It.visible&&R.push(w,Tt,It,j,ve.z,null,B)}}}let Et=w.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)ns(Et[Pt],B,j,q)}function Co(w,B,j,q){let{opaque:Y,transmissive:Et,transparent:Pt}=w;T.setupLightsView(j),Ue===!0&&nt.setGlobalState(D.clippingPlanes,j),q&&bt.viewport(st.copy(q)),Y.length>0&&Qe(Y,B,j),Et.length>0&&Qe(Et,B,j),Pt.length>0&&Qe(Pt,B,j),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function Sn(w,B,j,q){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[q.id]===void 0){let kt=$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[q.id]=new Wi(1,1,{generateMipmaps:!0,type:kt?Un:dn,minFilter:vs,samples:Math.max(4,ne.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:me.workingColorSpace})}let Et=T.state.transmissionRenderTarget[q.id],Pt=q.viewport||st;Et.setSize(Pt.z*D.transmissionResolutionScale,Pt.w*D.transmissionResolutionScale);let Tt=D.getRenderTarget(),It=D.getActiveCubeFace(),Bt=D.getActiveMipmapLevel();D.setRenderTarget(Et),D.getClearColor(tt),mt=D.getClearAlpha(),mt<1&&D.setClearColor(16777215,.5),D.clear(),je&&F.render(j);let Jt=D.toneMapping;D.toneMapping=jn;let he=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),T.setupLightsView(q),Ue===!0&&nt.setGlobalState(D.clippingPlanes,q),Qe(w,j,q),Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et),$t.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let ue=0,Ye=B.length;ue<Ye;ue++){let Te=B[ue],{object:Ae,geometry:_i,material:Ft,group:li}=Te;if(Ft.side===Mn&&Ae.layers.test(q.layers)){let fe=Ft.side;Ft.side=Xi,Ft.needsUpdate=!0,ni(Ae,j,q,_i,Ft,li),Ft.side=fe,Ft.needsUpdate=!0,kt=!0}}kt===!0&&(Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et))}D.setRenderTarget(Tt,It,Bt),D.setClearColor(tt,mt),he!==void 0&&(q.viewport=he),D.toneMapping=Jt}function Qe(w,B,j){let q=B.isScene===!0?B.overrideMaterial:null;for(let Y=0,Et=w.length;Y<Et;Y++){let Pt=w[Y],{object:Tt,geometry:It,group:Bt}=Pt,Jt=Pt.material;Jt.allowOverride===!0&&q!==null&&(Jt=q),Tt.layers.test(j.layers)&&ni(Tt,B,j,It,Jt,Bt)}}function ni(w,B,j,q,Y,Et){G!==null&&Y.isNodeMaterial&&G.setObject(w,Y),w.onBeforeRender(D,B,j,q,Y,Et),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Y.onBeforeRender(D,B,j,q,w,Et),Y.transparent===!0&&Y.side===Mn&&Y.forceSinglePass===!1?(Y.side=Xi,Y.needsUpdate=!0,D.renderBufferDirect(j,B,q,Y,w,Et),Y.side=Xs,Y.needsUpdate=!0,D.renderBufferDirect(j,B,q,Y,w,Et),Y.side=Mn):D.renderBufferDirect(j,B,q,Y,w,Et),w.onAfterRender(D,B,j,q,Y,Et)}function si(w){let B=0;for(let j of w)j.texture!==null&&B++;return B}function Bn(w,B,j){B.isScene!==!0&&(B=gi);let q=zt.get(w),Y=T.state.lights,Et=T.state.shadowsArray,Pt=Y.state.version,Tt=ot.getParameters(w,Y.state,Et,B,j,T.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?B.environment:null,q.fog=B.fog;let Jt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=C.get(w.envMap||q.environment,Jt),q.envMapRotation=q.environment!==null&&w.envMap===null?B.environmentRotation:w.envMapRotation,Bt===void 0&&(w.addEventListener("dispose",se),Bt=new Map,q.programs=Bt,q.programVariants=new Map);let he=Bt.get(It);if(he!==void 0){if(q.currentProgram===he&&q.lightsStateVersion===Pt)return Po(w,Tt),he}else Tt.uniforms=ot.getUniforms(w),G!==null&&w.isNodeMaterial&&G.build(w,j,Tt),w.onBeforeCompile(Tt,D),he=ot.acquireProgram(Tt,It),Bt.set(It,he),q.uniforms=Tt.uniforms;let kt=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(kt.clippingPlanes=nt.uniform),Po(w,Tt),q.needsLights=bs(w),q.lightsStateVersion=Pt,q.needsLights&&(kt.ambientLightColor.value=Y.state.ambient,kt.lightProbe.value=Y.state.probe,kt.sunLights.value=Y.state.sun,kt.sunLightShadows.value=Y.state.sunShadow,kt.directionalLights.value=Y.state.directional,kt.directionalLightShadows.value=Y.state.directionalShadow,kt.spotLights.value=Y.state.spot,kt.spotLightShadows.value=Y.state.spotShadow,kt.rectAreaLights.value=Y.state.rectArea,kt.ltc_1.value=Y.state.rectAreaLTC1,kt.ltc_2.value=Y.state.rectAreaLTC2,kt.pointLights.value=Y.state.point,kt.pointLightShadows.value=Y.state.pointShadow,kt.hemisphereLights.value=Y.state.hemi,kt.sunShadowMatrix.value=Y.state.sunShadowMatrix,kt.sunShadowCascade.value=Y.state.sunShadowCascade,kt.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,kt.spotLightMatrix.value=Y.state.spotLightMatrix,kt.spotLightMap.value=Y.state.spotLightMap,kt.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=si(T.state.lightProbeGridArray),q.currentProgram=he,q.uniformsList=null,he}function Ji(w,B,j,q,Y){let Et=zt.get(w),Pt=Et.currentProgram.id+","+q+","+Y,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Bn(w,B,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=q,Et.toneMapping=Y),Tt}function Ss(w){if(w.uniformsList===null){let B=w.currentProgram.getUniforms();w.uniformsList=Eo.seqWithValue(B.seq,w.uniforms)}return w.uniformsList}function Po(w,B){let j=zt.get(w);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function Io(w,B,j,q,Y){B.isScene!==!0&&(B=gi),Xt.resetTextureUnits();let Et=B.fog,Pt=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?B.environment:null,Tt=lt===null?D.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:me.workingColorSpace,It=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Bt=C.get(q.envMap||Pt,It),Jt=q.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,he=!!j.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),kt=!!j.morphAttributes.position,ue=!!j.morphAttributes.normal,Ye=!!j.morphAttributes.color,Te=jn;q.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Te=D.toneMapping);let Ae=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_i=Ae!==void 0?Ae.length:0,Ft=zt.get(q),li=T.state.lights;if(Ue===!0&&(oi===!0||w!==Q)){let Re=w===Q&&q.id===Z;nt.setState(q,w,Re)}let fe=!1,ss=!1;q.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==li.state.version||Y.isBatchedMesh&&Ft.batching===!1||!Y.isBatchedMesh&&Ft.batching===!0||Y.isBatchedMesh&&Ft.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ft.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ft.instancing===!1||!Y.isInstancedMesh&&Ft.instancing===!0||Y.isSkinnedMesh&&Ft.skinning===!1||!Y.isSkinnedMesh&&Ft.skinning===!0||Y.isInstancedMesh&&Ft.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Ft.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ft.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ft.instancingMorph===!1&&Y.morphTexture!==null||Ft.envMap!==Bt||q.fog===!0&&Ft.fog!==Et||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==nt.numPlanes||Ft.numIntersection!==nt.numIntersection)||Ft.vertexAlphas!==Jt||Ft.vertexTangents!==he||Ft.morphTargets!==kt||Ft.morphNormals!==ue||Ft.morphColors!==Ye||Ft.morphTargetsCount!==_i||Ft.numLightProbeGrids!==si(T.state.lightProbeGridArray)?fe=!0:(Ft.outputColorSpace!==Tt||Ft.toneMapping!==Te)&&(ss=!0):(fe=!0,Ft.__version=q.version);let ci=Ft.currentProgram;(fe===!0||ss===!0)&&(ci=ss===!0?Ji(q,B,Y,Tt,Te):Bn(q,B,Y),G&&q.isNodeMaterial&&G.onUpdateProgram(q,ci,Ft));let Er=!1,zn=!1,rs=!1,oe=ci.getUniforms(),ti=Ft.uniforms;if(bt.useProgram(ci.program)&&(Er=!0,zn=!0,rs=!0),q.id!==Z&&(Z=q.id,zn=!0),Er||Q!==w){bt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),oe.setValue(U,"projectionMatrix",w.projectionMatrix),oe.setValue(U,"viewMatrix",w.matrixWorldInverse);let hi=oe.map.cameraPosition;hi!==void 0&&hi.setValue(U,wi.setFromMatrixPosition(w.matrixWorld)),ne.logarithmicDepthBuffer&&oe.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&oe.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,zn=!0,rs=!0)}if(Ft.needsLights&&(li.state.sunShadowMap.length>0&&oe.setValue(U,"sunShadowMap",li.state.sunShadowMap,Xt),li.state.directionalShadowMap.length>0&&oe.setValue(U,"directionalShadowMap",li.state.directionalShadowMap,Xt),li.state.spotShadowMap.length>0&&oe.setValue(U,"spotShadowMap",li.state.spotShadowMap,Xt),li.state.pointShadowMap.length>0&&oe.setValue(U,"pointShadowMap",li.state.pointShadowMap,Xt)),Y.isSkinnedMesh){oe.setOptional(U,Y,"bindMatrix"),oe.setOptional(U,Y,"bindMatrixInverse");let Re=Y.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),oe.setValue(U,"boneTexture",Re.boneTexture,Xt))}Y.isBatchedMesh&&(oe.setOptional(U,Y,"batchingTexture"),oe.setValue(U,"batchingTexture",Y._matricesTexture,Xt),oe.setOptional(U,Y,"batchingIdTexture"),oe.setValue(U,"batchingIdTexture",Y._indirectTexture,Xt),oe.setOptional(U,Y,"batchingColorTexture"),Y._colorsTexture!==null&&oe.setValue(U,"batchingColorTexture",Y._colorsTexture,Xt));let Bi=j.morphAttributes;if((Bi.position!==void 0||Bi.normal!==void 0||Bi.color!==void 0)&&rt.update(Y,j,ci),(zn||Ft.receiveShadow!==Y.receiveShadow)&&(Ft.receiveShadow=Y.receiveShadow,oe.setValue(U,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&B.environment!==null&&(ti.envMapIntensity.value=B.environmentIntensity),ti.dfgLUT!==void 0&&(ti.dfgLUT.value=hT()),zn){if(oe.setValue(U,"toneMappingExposure",D.toneMappingExposure),Ft.needsLights&&br(ti,rs),Et&&q.fog===!0&&_t.refreshFogUniforms(ti,Et),_t.refreshMaterialUniforms(ti,q,St,At,T.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Re=M,hi=0;for(let Di of T.state.lightProbeGridArray)Di.texture!==null&&(Re.textures[hi]=Di.texture,Re.min[hi]=Di.boundingBox.min,Re.max[hi]=Di.boundingBox.max,Re.resolution[hi]=Di.resolution,hi++);for(let Di in Re)Re[Di].length=hi;ti.probesSH.value=Re.textures,ti.probesMin.value=Re.min,ti.probesMax.value=Re.max,ti.probesResolution.value=Re.resolution}Eo.upload(U,Ss(Ft),ti,Xt)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Eo.upload(U,Ss(Ft),ti,Xt),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&oe.setValue(U,"center",Y.center),oe.setValue(U,"modelViewMatrix",Y.modelViewMatrix),oe.setValue(U,"normalMatrix",Y.normalMatrix),oe.setValue(U,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let Re=q.uniformsGroups;for(let hi=0,Di=Re.length;hi<Di;hi++){let Va=Re[hi];Ht.update(Va,ci),Ht.bind(Va,ci)}}return ci}function br(w,B){w.ambientLightColor.needsUpdate=B,w.lightProbe.needsUpdate=B,w.sunLights.needsUpdate=B,w.sunLightShadows.needsUpdate=B,w.directionalLights.needsUpdate=B,w.directionalLightShadows.needsUpdate=B,w.pointLights.needsUpdate=B,w.pointLightShadows.needsUpdate=B,w.spotLights.needsUpdate=B,w.spotLightShadows.needsUpdate=B,w.rectAreaLights.needsUpdate=B,w.hemisphereLights.needsUpdate=B}function bs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(w,B,j){let q=zt.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),zt.get(w.texture).__webglTexture=B,zt.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:j,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,B){let j=zt.get(w);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(w,B=0,j=0){lt=w,X=B,O=j;let q=null,Y=!1,Et=!1;if(w){let Tt=zt.get(w);if(Tt.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(U.FRAMEBUFFER,Tt.__webglFramebuffer),st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest,bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),Z=-1;return}else if(Tt.__webglFramebuffer===void 0)Xt.setupRenderTarget(w);else if(Tt.__hasExternalTextures)Xt.rebindTextures(w,zt.get(w.texture).__webglTexture,zt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Jt=w.depthTexture;if(Tt.__boundDepthTexture!==Jt){if(Jt!==null&&zt.has(Jt)&&(w.width!==Jt.image.width||w.height!==Jt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(w)}}let It=w.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Bt[B])?q=Bt[B][j]:q=Bt[B],Y=!0):w.samples>0&&Xt.useMultisampledRTT(w)===!1?q=zt.get(w).__webglMultisampledFramebuffer:Array.isArray(Bt)?q=Bt[j]:q=Bt,st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest}else st.copy(Vt).multiplyScalar(St).floor(),dt.copy(ce).multiplyScalar(St).floor(),ut=re;if(j!==0&&(q=W),bt.bindFramebuffer(U.FRAMEBUFFER,q)&&bt.drawBuffers(w,q),bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),Y){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+B,Tt.__webglTexture,j)}else if(Et){let Tt=B;for(let It=0;It<w.textures.length;It++){let Bt=zt.get(w.textures[It]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(w!==null&&j!==0){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Tt.__webglTexture,j)}Z=-1};function wr(w){let B=zt.get(w);return(B.__readFormat!==w.format||B.__readType!==w.type)&&(B.__readFormat=w.format,B.__readType=w.type,B.__formatReadable=ne.textureFormatReadable(w.format),B.__typeReadable=ne.textureTypeReadable(w.type)),B}this.readRenderTargetPixels=function(w,B,j,q,Y,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){bt.bindFramebuffer(U.FRAMEBUFFER,It);try{let Bt=w.textures[Tt],Jt=Bt.format,he=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=wr(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=w.width-q&&j>=0&&j<=w.height-Y&&U.readPixels(B,j,q,Y,gt.convert(Jt),gt.convert(he),Et)}finally{let Bt=lt!==null?zt.get(lt).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(w,B,j,q,Y,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(B>=0&&B<=w.width-q&&j>=0&&j<=w.height-Y){bt.bindFramebuffer(U.FRAMEBUFFER,It);let Bt=w.textures[Tt],Jt=Bt.format,he=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=wr(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,ue),U.bufferData(U.PIXEL_PACK_BUFFER,Et.byteLength,U.STREAM_READ),U.readPixels(B,j,q,Y,gt.convert(Jt),gt.convert(he),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Ye=lt!==null?zt.get(lt).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,Ye);let Te=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await y0(U,Te,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,ue),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Et),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(ue),U.deleteSync(Te),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,B=null,j=0){let q=Math.pow(2,-j),Y=Math.floor(w.image.width*q),Et=Math.floor(w.image.height*q),Pt=B!==null?B.x:0,Tt=B!==null?B.y:0;Xt.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,j,0,0,Pt,Tt,Y,Et),bt.unbindTexture()},this.copyTextureToTexture=function(w,B,j=null,q=null,Y=0,Et=0){let Pt,Tt,It,Bt,Jt,he,kt,ue,Ye,Te=w.isCompressedTexture?w.mipmaps[Et]:w.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,Jt=j.min.y,he=j.isBox3?j.min.z:0;else{let oe=Math.pow(2,-Y);Pt=Math.floor(Te.width*oe),Tt=Math.floor(Te.height*oe),w.isDataArrayTexture?It=Te.depth:w.isData3DTexture?It=Math.floor(Te.depth*oe):It=1,Bt=0,Jt=0,he=0}q!==null?(kt=q.x,ue=q.y,Ye=q.z):(kt=0,ue=0,Ye=0);let Ae=gt.convert(B.format),_i=gt.convert(B.type),Ft;B.isData3DTexture?(Xt.setTexture3D(B,0),Ft=U.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Xt.setTexture2DArray(B,0),Ft=U.TEXTURE_2D_ARRAY):(Xt.setTexture2D(B,0),Ft=U.TEXTURE_2D),bt.activeTexture(U.TEXTURE0),bt.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,B.flipY),bt.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),bt.pixelStorei(U.UNPACK_ALIGNMENT,B.unpackAlignment);let li=bt.getParameter(U.UNPACK_ROW_LENGTH),fe=bt.getParameter(U.UNPACK_IMAGE_HEIGHT),ss=bt.getParameter(U.UNPACK_SKIP_PIXELS),ci=bt.getParameter(U.UNPACK_SKIP_ROWS),Er=bt.getParameter(U.UNPACK_SKIP_IMAGES);bt.pixelStorei(U.UNPACK_ROW_LENGTH,Te.width),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Te.height),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,Bt),bt.pixelStorei(U.UNPACK_SKIP_ROWS,Jt),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,he);let zn=w.isDataArrayTexture||w.isData3DTexture,rs=B.isDataArrayTexture||B.isData3DTexture;if(w.isDepthTexture){let oe=zt.get(w),ti=zt.get(B),Bi=zt.get(oe.__renderTarget),Re=zt.get(ti.__renderTarget);bt.bindFramebuffer(U.READ_FRAMEBUFFER,Bi.__webglFramebuffer),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let hi=0;hi<It;hi++)zn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(w).__webglTexture,Y,he+hi),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(B).__webglTexture,Et,Ye+hi)),U.blitFramebuffer(Bt,Jt,Bt+Pt,Jt+Tt,kt,ue,kt+Pt,ue+Tt,U.DEPTH_BUFFER_BIT,U.NEAREST);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(Y!==0||w.isRenderTargetTexture||zt.has(w)){let oe=zt.get(w),ti=zt.get(B);bt.bindFramebuffer(U.READ_FRAMEBUFFER,N),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,V);for(let Bi=0;Bi<It;Bi++)zn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,oe.__webglTexture,Y,he+Bi):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,oe.__webglTexture,Y),rs?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ti.__webglTexture,Et,Ye+Bi):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ti.__webglTexture,Et),Y!==0?U.blitFramebuffer(Bt,Jt,Bt+Pt,Jt+Tt,kt,ue,kt+Pt,ue+Tt,U.COLOR_BUFFER_BIT,U.NEAREST):rs?U.copyTexSubImage3D(Ft,Et,kt,ue,Ye+Bi,Bt,Jt,Pt,Tt):U.copyTexSubImage2D(Ft,Et,kt,ue,Bt,Jt,Pt,Tt);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else rs?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Ft,Et,kt,ue,Ye,Pt,Tt,It,Ae,_i,Te.data):B.isCompressedArrayTexture?U.compressedTexSubImage3D(Ft,Et,kt,ue,Ye,Pt,Tt,It,Ae,Te.data):U.texSubImage3D(Ft,Et,kt,ue,Ye,Pt,Tt,It,Ae,_i,Te):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Et,kt,ue,Pt,Tt,Ae,_i,Te.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Et,kt,ue,Te.width,Te.height,Ae,Te.data):U.texSubImage2D(U.TEXTURE_2D,Et,kt,ue,Pt,Tt,Ae,_i,Te);bt.pixelStorei(U.UNPACK_ROW_LENGTH,li),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,fe),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,ss),bt.pixelStorei(U.UNPACK_SKIP_ROWS,ci),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,Er),Et===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&U.generateMipmap(Ft),bt.unbindTexture()},this.initRenderTarget=function(w){zt.get(w).__webglFramebuffer===void 0&&Xt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xt.setTextureCube(w,0):w.isData3DTexture?Xt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xt.setTexture2DArray(w,0):Xt.setTexture2D(w,0),bt.unbindTexture()},this.resetState=function(){X=0,O=0,lt=null,bt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=me._getDrawingBufferColorSpace(t),e.unpackColorSpace=me._getUnpackColorSpace()}};function es(n,t,e,i){return new vo({glslVersion:La,vertexShader:n,fragmentShader:t,uniforms:e,transparent:!0,depthTest:i,depthWrite:i,side:Mn})}function ka(n,t,e,i=!1){let s=es(n,t,e,!1);return s.blending=i?Zc:xs,i&&(s.blendEquation=Kc,s.blendSrc=ba,s.blendDst=ba),s}var On=`
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
uniform vec3 key;      // direction to the light
`,Hh=`
// The direction to the side of a line through a node, at a right angle to "sight" (length 1),
// drawn out at a bend so that the ribbon keeps its width; sharp folds are cut off.
vec3 sideways(vec3 before, vec3 here, vec3 after, vec3 sight) {
  vec3 a = cross(here - before, sight);
  vec3 b = cross(after - here, sight);
  float la = length(a), lb = length(b);
  a = la > 0.0 ? a / la : vec3(0.0);
  b = lb > 0.0 ? b / lb : a;
  if (la == 0.0) a = b;
  vec3 sum = a + b;
  float size = length(sum);
  if (size < 0.7) return b;
  sum /= size;
  return sum / max(0.6, dot(sum, b));
}
`,r_=`${On}${Hh}
uniform highp sampler2D points;
uniform int columns;
uniform int head;
in vec3 tint;
out float across;
out float age;
out vec3 colourOf;
vec3 point(int row, int step) {
  return texelFetch(points, ivec2((head + clamp(step, 0, columns - 1)) % columns, row), 0).xyz;
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  int row = i / columns, step = i % columns;
  vec3 here = point(row, step);
  vec3 side = sideways(point(row, step - 1), here, point(row, step + 1), normalize(eye - here));
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  age = 1.0 - float(step) / float(columns - 1);
  colourOf = tint;
  gl_Position = projection * view * vec4(here + side * across * 2.0 * perPixel, 1.0);
}
`,o_=`
precision highp float;
in float across;
in float age;
in vec3 colourOf;
out vec4 colour;
void main() {
  float cover = clamp(1.8 - 2.0 * abs(across), 0.0, 1.0);
  colour = vec4(colourOf, 0.75 * cover * (1.0 - age) * (1.0 - age));
}
`,a_=`${On}
in vec3 position;
in vec4 ink;           // colour, kind: 0 ball, 1 eye bolt, 2 ring
in vec2 sizes;         // diameter [m], least diameter in CSS pixels
out vec4 colourOf;
out float diameter;    // CSS pixels
void main() {
  vec4 seen = view * vec4(position, 1.0);
  diameter = max(sizes.x / (pixel * -seen.z), sizes.y);
  colourOf = ink;
  gl_Position = projection * seen;
  seen.z *= 1.0 - min(0.5, pixel * diameter);  // before the rope that ends in it
  vec4 nearer = projection * seen;
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  gl_PointSize = (diameter + 2.0) * ratio;
}
`,l_=`${On}
in vec4 colourOf;
in float diameter;
out vec4 colour;
void main() {
  float radius = 0.5 * diameter;
  vec2 at = (gl_PointCoord * 2.0 - 1.0) * vec2(1.0, -1.0) * (radius + 1.0);
  int kind = int(colourOf.w + 0.5);
  if (kind == 2) {
    float band = abs(length(at) - radius + 1.2) - 1.2;
    colour = vec4(colourOf.rgb, clamp(0.5 - band, 0.0, 1.0));
  } else if (kind == 1) {
    float tube = 0.3 * radius;
    float x = (length(at) - 0.7 * radius) / tube;
    float z = sqrt(max(0.0, 1.0 - x * x));
    vec3 n = vec3(at / max(length(at), 1e-3) * clamp(x, -1.0, 1.0), z);
    float light = 0.42 + 0.62 * max(dot(n, normalize(vec3(-0.35, 0.8, 0.6))), 0.0);
    float glint = pow(max(dot(n, normalize(vec3(-0.2, 0.6, 0.9))), 0.0), 24.0);
    colour = vec4(colourOf.rgb * light + 0.25 * glint, clamp(tube * (1.0 - abs(x)) + 0.5, 0.0, 1.0));
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`,c_=`${On}
uniform highp sampler2D points;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec4 here = texelFetch(points, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0);
  vec4 seen = view * vec4(here.xyz, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = here.w > 1e30 ? 0.0 : dot_ * ratio;
}
`,h_=`
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord * 2.0 - 1.0);
  float cover = 1.0 - smoothstep(0.7, 1.0, away);
  if (cover <= 0.0) discard;
  colour = vec4(ink, cover);
}
`,u_=`${On}
in vec3 position;      // a place on the arrow's line
in vec3 line;          // the arrow's direction
in vec4 ink;           // colour, CSS pixels to the side
in float edge;         // half the arrow's width there [CSS pixels]
out vec3 colourOf;
out float away;
out float halfWidth;
void main() {
  vec3 side = cross(line, eye - position);
  float size = length(side);
  side = size > 0.0 ? side / size : right;
  float perPixel = pixel * -(view * vec4(position, 1.0)).z;
  colourOf = ink.rgb;
  away = ink.w;
  halfWidth = edge;
  gl_Position = projection * view * vec4(position + side * ink.w * perPixel, 1.0);
}
`,d_=`
precision highp float;
in vec3 colourOf;
in float away;
in float halfWidth;
uniform float round_;  // 1: shaded as a round bar
out vec4 colour;
void main() {
  float u = clamp(away / max(halfWidth, 1.0), -1.0, 1.0);
  float light = mix(1.0, 0.55 + 0.5 * sqrt(max(0.0, 1.0 - (u + 0.35) * (u + 0.35) / 1.9)), round_);
  colour = vec4(colourOf * light, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;var Sf=256,bf=7,f_=[0,1,2,1,3,2,4,5,6],Ba=class{constructor(t,e=!1){let i=new mi;for(let[r,o]of[["position",3],["line",3],["ink",4],["edge",1]]){let a=new ri(new Float32Array(o*bf*Sf),o);a.setUsage(Ia),i.setAttribute(r,a)}let s=[];for(let r=0;r<Sf;r++)s.push(...f_.map(o=>o+bf*r));i.setIndex(s),this.mesh=new Mi(i,es(u_,d_,{...t,round_:{value:Number(e)}},e)),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?.5:2.5}update(t,e){let i=Math.min(Sf,t.length);if(this.mesh.visible=i>0,!i)return;let s=this.mesh.geometry,[r,o,a,l]=["position","line","ink","edge"].map(c=>s.getAttribute(c));for(let c=0;c<i;c++){let{from:d,to:u,colour:h,pixels:f,head:g}=t[c],_=[u[0]-d[0],u[1]-d[1],u[2]-d[2]],m=Math.hypot(_[0],_[1],_[2]),p=g&&m>0?Math.min(.5,5.5*f*e/m):0,y=f/2,A=g?2.2*f:0;[[0,y,-1],[0,y,1],[1-p,y,-1],[1-p,y,1],[1-p,A,-1],[1-p,A,1],[1,0,0]].forEach(([R,T,v],E)=>{let k=bf*c+E;r.setXYZ(k,d[0]+R*_[0],d[1]+R*_[1],d[2]+R*_[2]),o.setXYZ(k,_[0],_[1],_[2]),a.setXYZW(k,h[0],h[1],h[2],v*(T&&T+1)),l.setX(k,T)})}r.needsUpdate=o.needsUpdate=a.needsUpdate=l.needsUpdate=!0,s.setDrawRange(0,f_.length*i)}};var p_=`
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
`,uT=`${On}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform vec3 first;
uniform vec3 second;
uniform vec3 center;   // on the ground, on a crossing of lines
uniform float spacing; // of the lines [m]
uniform float reach;   // how far the floor is seen [m]
uniform float solid;   // 1: there is a ground to land on
uniform vec3 sky;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 grid;
uniform float pool;    // how much lighter the middle is
out vec4 colour;
// How much of a pixel a line covers: "at" in lines, "wide" pixels; "step_" lines per pixel.
float line(float at, float step_, float wide) {
  float away = abs(fract(at - 0.5) - 0.5) / max(step_, 1e-6);
  float part = clamp(0.5 * wide + 0.5 - away, 0.0, 1.0);
  return mix(part, min(1.0, wide * step_), smoothstep(0.15, 0.5, step_));
}
void main() {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 ray = ahead + (right * at.x + top * at.y) * pixel;
  float rise = dot(normalize(ray), up);
  vec3 highest = ahead + top * (0.5 * size.y * pixel);
  float most = max(dot(normalize(highest), up), 0.12);
  vec3 shown = mix(horizon, sky, smoothstep(0.0, 1.0, clamp(rise / most, 0.0, 1.0)));
  float above = dot(eye - center, up);
  float away = above / max(abs(dot(ray, up)), 1e-5) * (rise < 0.0 ? 1.0 : -1.0);
  if (away > 0.0) {
    vec3 place = eye + ray * away - center;
    vec2 q = vec2(dot(place, first), dot(place, second)) / spacing;
    float far = length(q) * spacing / reach;
    float fade = exp(-2.4 * far * far);
    // The size of a pixel on the floor: along the ray it is drawn out.
    float perPixel = pixel * away * length(ray);
    float drawn = perPixel / max(abs(rise), 1e-3);
    vec3 level = ray - up * dot(ray, up);
    vec2 flow = abs(vec2(dot(level, first), dot(level, second))) / max(length(level), 1e-6);
    vec2 step_ = (perPixel + (drawn - perPixel) * flow) / spacing;
    float fine = max(line(q.x, step_.x, 1.0), line(q.y, step_.y, 1.0));
    float coarse = max(line(q.x / 5.0, step_.x / 5.0, 1.5), line(q.y / 5.0, step_.y / 5.0, 1.5));
    float ink = max(0.5 * fine * exp(-5.0 * far * far), coarse) * fade;
    if (above > 0.0) {
      vec3 floor_ = ground + pool * exp(-9.0 * far * far);
      shown = mix(horizon, floor_, clamp(1.25 * fade, 0.0, 1.0));
      shown = mix(shown, grid, 0.9 * ink);
    } else shown = mix(shown, grid, 0.5 * ink);
  }
  // A little noise, so that no bands are seen.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(shown + (noise - 0.5) / 255.0, 1.0);
}
`,dT=`
precision highp float;
uniform highp sampler2D backdrop;
out vec4 colour;
void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0); }
`,Gh=class{constructor(t){this.shared=t;let e=()=>({value:new J});this.uniforms={size:{value:new ge(1,1)},top:e(),ahead:e(),first:e(),second:e(),center:e(),spacing:{value:1},reach:{value:1},solid:{value:0},sky:e(),horizon:e(),ground:e(),grid:e(),pool:{value:0}},this.target=new Wi(1,1,{depthBuffer:!1}),this.target.texture.minFilter=this.target.texture.magFilter=pi,this.texture={value:this.target.texture},this.scene=new ur,this.scene.add(m_(ka(p_,uT,{...t,...this.uniforms}))),this.mesh=m_(ka(p_,dT,{backdrop:this.texture})),this.mesh.renderOrder=-5,this.key=""}setTheme(t){let{sky:e,horizon:i,ground:s,grid:r,pool:o}=this.uniforms;e.value.set(...t.background),i.value.set(...t.horizon),s.value.set(...t.ground),r.value.set(...t.grid),o.value=tp(t.dark),this.key=""}resize(t,e){this.target.setSize(t,e),this.key=""}update(t,e,i,s){let r=[s.version,i.height,i.spacing,i.solid,...i.center].join();if(r===this.key)return;this.key=r;let{uniforms:o}=this;o.size.value.set(s.width,s.height),o.top.value.set(...s.top),o.ahead.value.set(-s.toward[0],-s.toward[1],-s.toward[2]),o.first.value.set(...s.first),o.second.value.set(...s.second),o.center.value.set(...i.center),o.spacing.value=i.spacing,o.reach.value=i.radius,o.solid.value=i.solid?1:0,t.setRenderTarget(this.target),t.render(this.scene,e),t.setRenderTarget(null)}dispose(){this.target.dispose()}};function m_(n){let t=new mi;t.setIndex([0,1,2]);let e=new Mi(t,n);return e.frustumCulled=!1,e}var fT={round:0,eye:1,ring:2},Wh=class{constructor(t){this.room=0,this.points=new pr(void 0,es(a_,l_,t,!0)),this.points.frustumCulled=!1,this.points.renderOrder=3,this.grow(32)}grow(t){this.room=t,this.points.geometry.dispose();let e=new mi;for(let[i,s]of[["position",3],["ink",4],["sizes",2]]){let r=new ri(new Float32Array(s*t),s);r.setUsage(Ia),e.setAttribute(i,r)}this.points.geometry=e}update(t){t.length>this.room&&this.grow(2*t.length);let e=this.points.geometry,[i,s,r]=["position","ink","sizes"].map(o=>e.getAttribute(o));t.forEach((o,a)=>{i.setXYZ(a,o.x,o.y,o.z);let[l,c,d]=o.colour;s.setXYZW(a,l,c,d,fT[o.kind]),r.setXY(a,o.size,o.pixels)}),i.needsUpdate=s.needsUpdate=r.needsUpdate=!0,e.setDrawRange(0,t.length),this.points.visible=t.length>0}};var g_=`
uniform highp sampler2D points;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], has a point before, after, length of rope to a free end [m]
vec4 point(int i) { return texelFetch(points, ivec2(i % columns, i / columns), 0); }
`,__=`${On}${Hh}${g_}
uniform highp sampler2D normals; // of the rope, and the length of rope up to here [m]
uniform float laid;    // 1: there are strands
uniform float thick;   // the least radius as drawn in the scene's middle [m]
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float phase;       // turns of the strands
out vec2 turn;         // the rope's normal, as seen: to the side and towards the eye
out float slope;       // of the rope towards the eye
out float toEnd;       // radii to a free end
out vec3 side;
out vec3 toward;
out vec3 ropeTint;
out float behind;
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = point(i);
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here.xyz;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here.xyz;
  vec3 sight = normalize(eye - here.xyz);
  vec3 out_ = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  ropeTint = tint;
  vec3 along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float size = length(out_);
  side = size > 0.0 ? out_ / size : right;
  toward = normalize(cross(side, along));
  vec4 material = laid < 0.5 ? vec4(up, 0.0) : texelFetch(normals, ivec2(i % columns, i / columns), 0);
  turn = vec2(dot(material.xyz, side), dot(material.xyz, toward));
  float radius = max(look.x, 1e-9); // where ropes are drawn thicker than they are, their lay is longer
  float lay = 7.0 * radius * exp2(floor(log2(max(thick / radius, 1.0)) + 0.5));
  phase = material.w / lay;
  float cot = dot(along, sight) / max(length(cross(along, sight)), 1e-3);
  slope = cot / sqrt(1.0 + 0.6 * cot * cot);
  toEnd = look.w / (halfWidth * perPixel);
  vec3 place = here.xyz + out_ * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`,x_=`${On}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float rim;     // what is left of the light at the rope's edge: 1 where the floor is dark
uniform float laid;    // 1: draw strands
in float across;
in float halfWidth;
in float value;
in float phase;
in vec2 turn;
in float slope;
in float toEnd;
in vec3 side;
in vec3 toward;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
const float CENTRE = 0.5359, STRAND = 0.4641; // of three strands in a rope of radius 1
void main() {
  if (behind > 0.0 || value > 1e30) discard;
  float w = across * (halfWidth + 1.0);
  float u = clamp(w / halfWidth, -1.0, 1.0);
  vec3 n = vec3(u, sqrt(1.0 - u * u), 0.0); // to the side, towards the eye, along
  float edge = 1.0, shade = 1.0;
  float strands = laid * smoothstep(1.6, 3.2, halfWidth);
  bool whipped = toEnd < 4.2;
  if (strands > 0.0 && !whipped) {
    float angle = 6.2831853 * (phase + slope * n.y * 0.1214);
    float c = cos(angle), s = sin(angle);
    vec2 t = normalize(turn + 1e-6);
    vec2 centre = CENTRE * vec2(t.x * c + t.y * s, t.y * c - t.x * s);
    float best = -2.0, outer = -1.0;
    vec2 hit = centre;
    for (int k = 0; k < 3; k++) {
      float off = u - centre.x;
      float q = STRAND * STRAND - off * off;
      float z = centre.y + sqrt(max(q, 0.0));
      if (q > 0.0 && z > best) { best = z; hit = centre; }
      outer = max(outer, sign(u) * centre.x + STRAND);
      centre = vec2(-0.5 * centre.x - 0.8660254 * centre.y, 0.8660254 * centre.x - 0.5 * centre.y);
    }
    vec2 o = vec2(u - hit.x, max(best, hit.y) - hit.y) / STRAND;
    vec3 lie = vec3(0.8976 * hit.y, -0.8976 * hit.x, 1.0); // the direction of the strand
    vec3 m = vec3(o, 0.0);
    m = normalize(m - lie * (dot(m, lie) / dot(lie, lie)));
    float groove = smoothstep(0.46, 0.93, length(vec2(u, best)));
    n = normalize(mix(n, m, strands));
    edge = mix(1.0, outer, strands);
    shade = mix(1.0, 0.42 + 0.58 * groove, strands * mix(0.7, 1.0, smoothstep(4.0, 10.0, halfWidth)));
  }
  float cover = clamp(edge * halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  if (whipped) {
    base = vec3(0.86, 0.82, 0.74); // whipped with twine
    shade = 0.8 + 0.2 * cos(toEnd * 9.0);
  }
  vec3 normal = normalize(side) * n.x + normalize(toward) * n.y + cross(toward, side) * n.z;
  float wrapped = max(dot(normal, key) + 0.25, 0.0) / 1.25;
  float front = max(n.y, 0.0);
  float light = (0.36 + 0.2 * dot(normal, up) + 0.62 * wrapped * wrapped + 0.3 * front) * shade;
  vec3 half_ = normalize(key + normalize(toward));
  float sheen = 0.1 * pow(max(dot(normal, half_), 0.0), 22.0);
  float band = 1.0 - smoothstep(0.7, 2.0, edge * halfWidth - abs(w));
  vec3 lit = base * base * light * mix(1.0, rim, band) + sheen * shade;
  colour = vec4(sqrt(lit), cover);
}
`,v_=`${On}${Hh}${g_}
uniform float height;  // of the ground along up [m]
out float across;
out float strength;
out float sharp;
vec3 fallen(int i) {
  vec3 p = point(i).xyz;
  float above = dot(p, up) - height;
  vec3 level = key - up * dot(key, up);
  return p - above * (up + 0.75 * level / dot(key, up));
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = fallen(i);
  vec3 before = look.y > 0.5 ? fallen(i - 1) : here;
  vec3 after = look.z > 0.5 ? fallen(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float above = dot(point(i).xyz, up) - height;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  float radius = max(look.x, 0.5 * least * perPixel);
  float blur = 0.11 * max(above, 0.0);
  float wide = sqrt(radius * radius + blur * blur);
  strength = above < -radius ? 0.0 : radius / (radius + 0.38 * blur);
  if (point(i).w > 1e30) strength = 0.0;
  strength *= min(look.y, look.z); // it fades out at the ends
  sharp = radius / wide;
  gl_Position = projection * view * vec4(here + side * across * 1.7 * wide, 1.0);
}
`,y_=`
precision highp float;
uniform highp sampler2D backdrop;
uniform float ink;
in float across;
in float strength;
in float sharp;
out vec4 colour;
void main() {
  float soft = exp(-3.0 * across * across) - 0.05;
  float hard = 1.0 - smoothstep(0.45, 0.8, abs(across));
  float dark = ink * strength * max(mix(soft, hard, sharp * sharp), 0.0);
  colour = vec4(texelFetch(backdrop, ivec2(gl_FragCoord.xy), 0).rgb * (1.0 - dark), 1.0);
}
`;var S_=1e6,Xh=class{constructor(t,e){this.uniforms={points:{value:null},normals:{value:null},columns:{value:1},least:{value:4},thick:{value:1},laid:{value:1},map:{value:null},range:{value:new ge(0,1)},plain:{value:!1},rim:{value:1},height:{value:0}},this.shadowInk={value:.3},this.dotInk={value:new J(0,0,0)};let i={...t,...this.uniforms};this.ropes=new Mi(void 0,es(__,x_,i,!0)),this.shadow=new Mi(void 0,ka(v_,y_,{...i,backdrop:e,ink:this.shadowInk},!0)),this.dots=new pr(void 0,es(c_,h_,{...i,ink:this.dotInk,dot_:{value:5}},!0)),this.shadow.renderOrder=-2,this.ropes.renderOrder=1,this.dots.renderOrder=2;for(let s of[this.ropes,this.shadow,this.dots])s.frustumCulled=!1}setTheme(t){this.uniforms.map.value?.dispose(),this.uniforms.map.value=gT(t.dark),this.uniforms.rim.value=t.rim,this.shadowInk.value=t.dark?.75:.42,this.dotInk.value.set(...t.node)}setLine(t){let e=mT(t.shape);this.ropes.geometry.dispose(),this.ropes.geometry=e,this.shadow.geometry=e;let i=new mi,s=t.shape.ropes.flatMap(({first:r,count:o})=>Array.from({length:Math.ceil(o/t.steps)},(a,l)=>r+l*t.steps));i.setIndex(new ri(new Uint32Array(s),1)),this.dots.geometry.dispose(),this.dots.geometry=i;for(let r of["points","normals"])this.uniforms[r].value?.dispose(),this.uniforms[r].value=pT(t[r]);this.uniforms.columns.value=rr(t.points.length/4)[0],this.uniforms.laid.value=t.framed?1:0}moved(){let{points:t,normals:e,laid:i}=this.uniforms;t.value&&(t.value.needsUpdate=!0),e.value&&i.value&&(e.value.needsUpdate=!0)}dispose(){this.uniforms.points.value?.dispose(),this.uniforms.normals.value?.dispose(),this.uniforms.map.value?.dispose(),this.ropes.geometry.dispose(),this.dots.geometry.dispose()}};function pT(n){let[t,e]=rr(n.length/4),i=new gs(n,t,e,qi,$i);return i.internalFormat="RGBA32F",i.needsUpdate=!0,i}function mT(n){let t=new Float32Array(8*n.nodes),e=new Float32Array(6*n.nodes),i=[];for(let r of n.ropes)for(let o=0;o<r.count;o++){let a=r.first+o,l=o>0,c=o<r.count-1,d=Math.min(r.loose[0]?o*r.spacing:S_,r.loose[1]?(r.count-1-o)*r.spacing:S_);for(let u of[2*a,2*a+1])t.set([r.radius,Number(l),Number(c),d],4*u),e.set(r.colour,3*u);if(c){let u=2*a;i.push(u,u+1,u+2,u+1,u+3,u+2)}}let s=new mi;return s.setAttribute("look",new ri(t,4)),s.setAttribute("tint",new ri(e,3)),s.setIndex(new ri(new Uint32Array(i),1)),s}function gT(n){let t=new Uint8Array(4*256);Ur(n).forEach((i,s)=>t.set([...i.map(r=>Math.round(255*r)),255],4*s));let e=new gs(t,256,1);return e.minFilter=Pi,e.magFilter=Pi,e.needsUpdate=!0,e}var $h=class{constructor(t){this.uniforms={points:{value:null},columns:{value:360},head:{value:0}},this.mesh=new Mi(void 0,es(r_,o_,{...t,...this.uniforms},!1)),this.mesh.frustumCulled=!1,this.trails=null,this.version=-1}update(t){if(this.mesh.visible=t!==null&&!t.empty,!t||(t!==this.trails&&this.rebuild(t),t.version===this.version))return;this.version=t.version,this.uniforms.head.value=t.head;let e=this.uniforms.points.value;e&&(e.needsUpdate=!0)}rebuild(t){this.trails=t,this.version=-1;let e=t.nodes.length;this.uniforms.points.value?.dispose();let i=new gs(t.points,360,e,qi,$i);i.internalFormat="RGBA32F",this.uniforms.points.value=i;let s=new Float32Array(6*360*e),r=[];for(let a=0;a<e;a++)for(let l=0;l<360;l++){let c=2*(a*360+l);s.set([...t.colours[a],...t.colours[a]],3*c),l<359&&r.push(c,c+1,c+2,c+1,c+3,c+2)}let o=new mi;o.setAttribute("tint",new ri(s,3)),o.setIndex(r),this.mesh.geometry.dispose(),this.mesh.geometry=o}};var _T=[24e3,4e4],xT=[2400,2600],vT=.65,qh=class{constructor(t){let e=t.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!e)throw new Error("no WebGL2");this.name="webgl",this.canvas=t,this.three=new Bh({canvas:t,context:e,antialias:!1}),this.three.outputColorSpace=ks,this.shared={view:{value:new Oe},projection:{value:new Oe},eye:{value:new J},up:{value:new J},right:{value:new J},key:{value:new J(0,0,1)},pixel:{value:.001},ratio:{value:1}},this.scene=new ur,this.scene.matrixWorldAutoUpdate=!1,this.camera=new mr,this.soft=yT(e),this.line=new jr(...this.soft?xT:_T),this.backdrop=new Gh(this.shared),this.ribbons=new Xh(this.shared,this.backdrop.texture),this.markers=new Wh(this.shared),this.arrows=new Ba(this.shared),this.posts=new Ba(this.shared,!0),this.trails=new $h(this.shared),this.scene.add(this.backdrop.mesh,this.ribbons.shadow,this.trails.mesh,this.ribbons.ropes,this.ribbons.dots,this.markers.points,this.arrows.mesh,this.posts.mesh)}setShape(t){this.line.setShape(t)}setTheme(t){let e=new _e().setRGB(...t.background,ks);this.three.setClearColor(e,1),this.backdrop.setTheme(t),this.ribbons.setTheme(t)}resize(t,e,i){this.three.setPixelRatio(i),this.three.setSize(t,e,!1),this.shared.ratio.value=i,this.backdrop.resize(this.canvas.width,this.canvas.height)}draw(t){let{camera:e}=t;this.shared.view.value.fromArray(e.view),this.shared.projection.value.fromArray(e.projection),this.shared.eye.value.set(...e.eye),this.shared.up.value.set(...e.up),this.shared.right.value.set(...e.right),this.shared.pixel.value=1/e.focal,this.shared.key.value.set(...e.light),this.line.update(t)?this.ribbons.setLine(this.line):t.moved&&this.ribbons.moved();let i=this.ribbons.uniforms,s=.5*t.pixels*e.pose.distance/e.focal;Math.abs(Math.log2(s/i.thick.value))>vT&&(i.thick.value=s),i.range.value.set(t.range.low,t.range.high),i.plain.value=t.plain,i.least.value=t.pixels,i.height.value=t.ground.height,this.ribbons.shadow.visible=e.eyeHeight(t.ground.height)>0,this.ribbons.dots.visible=t.dots,this.backdrop.update(this.three,this.camera,t.ground,e),this.markers.update(t.markers),this.arrows.update(t.arrows,e.pose.distance/e.focal),this.posts.update(t.posts,e.pose.distance/e.focal),this.trails.update(t.trails),this.three.render(this.scene,this.camera)}clear(){this.three.clear()}dispose(){this.ribbons.dispose(),this.backdrop.dispose(),this.three.dispose()}};function yT(n){let t=n.getExtension("WEBGL_debug_renderer_info"),e=t?String(n.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}function b_(n){if(new URLSearchParams(location.search).get("renderer")!=="canvas")try{return new qh(n)}catch(e){console.info("Canvas 2D is used:",e);let i=n.cloneNode();return n.replaceWith(i),new ia(i)}return new ia(n)}var Yh=class{constructor(){this.listeners=new Map}on(t,e){let i=this.listeners.get(t)??[];i.push(e),this.listeners.set(t,i)}emit(t,e){for(let i of this.listeners.get(t)??[])i(e)}};var Zh=class extends Yh{constructor(t){super(),this.source=t,this.hello=null,this.layout=null,this.parameters=[],this.presets=[],this.status=null,this.stability=[],this.broken=null,this.frame=null,this.frames=0,this.connection="connecting",this.lastId=0,this.pendingFrame=-1,this.resting=!1,this.waiting=new Map}open(){this.source.open({message:t=>this.take(t),frame:t=>this.takeFrame(t),state:(t,e)=>{if(this.connection=t,t!=="open"){let i={type:"error",text:"The server is not there."};for(let{reject:s}of this.waiting.values())s(i);this.waiting.clear()}this.emit("connection",{state:t,text:e})}})}can(t){return this.hello?.can.includes(t)??!1}send(t){this.can(t.type)&&this.source.send(t)}ask(t){let e=++this.lastId;return new Promise((i,s)=>{if(!this.can(t.type)){s({type:"error",text:`${t.type}: cannot be done here`});return}this.waiting.set(e,{resolve:i,reject:s}),this.source.send({...t,id:e})})}async tell(t){try{return await this.ask(t),!0}catch(e){return this.emit("error",e),!1}}take(t){switch(t.type){case"hello":this.hello=t;break;case"layout":t.layout!==this.layout?.layout&&(this.frame=null),this.layout=t;break;case"parameters":this.parameters=t.parameters,this.emit("parameters",this.parameters);return;case"presets":this.presets=t.presets,this.emit("presets",this.presets);return;case"status":this.status=t,!t.broken&&this.broken&&(this.broken=null,this.emit("broken",null));break;case"stability":this.stability=t.variants,this.emit("stability",this.stability);return;case"broken":this.broken=t;break;case"done":case"error":this.answer(t);return}this.emit(t.type,t)}answer(t){let e=this.waiting.get(t.id);this.waiting.delete(t.id),t.type==="done"?e?.resolve(t):e?e.reject(t):this.emit("error",t)}takeFrame(t){if(this.pendingFrame=qf(t),!this.layout||$a(t)!==this.layout.layout){this.acknowledge();return}let e=this.frame;this.frame=Nr(t,this.layout),this.frames++,this.emit("frame",this.frame),e&&Yf(e)}acknowledge(){this.resting=!this.resting,!(this.pendingFrame<0||this.resting)&&(this.source.used(this.pendingFrame),this.pendingFrame=-1)}};function w_(n){let t=atob(n.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function E_(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function T_({columns:n,low:t,step:e,order:i,planes:s},r,o){let a=r*n;if(o.length!==a*s)throw new Error("the recording is damaged");let l=new Int32Array(a);for(let c=0;c<n;c++){let d=0,u=0;for(let h=c*r;h<(c+1)*r;h++){let f=o[h];for(let _=1;_<s;_++)f|=o[_*a+h]<<8*_;let g=f>>>1^-(f&1);i===2?d+=u+=g:d+=g,l[h]=d}}return{columns:n,rows:r,low:t,step:e,whole:l}}function Mr({columns:n,rows:t,low:e,step:i,whole:s},r,o){for(let a=0;a<n;a++)o[a]=e[a]+i[a]*s[a*t+r];return o}var bT=48,wT=250,ET=600,TT=.1,AT=["play","pause","step","speed","seek","reset"];function R_(){let n=document.getElementById("recording"),t=document.getElementById("recording-data");return!n||!t?null:new wf(JSON.parse(n.textContent??""),t.textContent??"")}var wf=class{constructor(t,e){this.base="",this.header=t,this.text=e,this.time=0,this.speed=1,this.playing=!0,this.number=0,this.shown=-1,this.leapt=!1,this.layout=-1,this.last=0,this.lastStatus=0,this.parts=[],this.times=new Float64Array(0),this.events=null,this.jumped=()=>{}}async open(t){this.events=t;try{await this.load()}catch(i){t.state("damaged",`This page cannot be shown: ${i instanceof Error?i.message:i}.`);return}t.state("open",""),t.message(this.hello()),this.tellLayout(0),t.message({type:"parameters",parameters:[]}),t.message({type:"presets",presets:[]}),this.tellStatus(),this.last=performance.now();let e=i=>{this.tick(i),requestAnimationFrame(e)};requestAnimationFrame(e)}async load(){let t=w_(this.text);this.text="";let e=0,i=async(c,d)=>{let u=t.slice(e,e+=c.bytes);return T_(c,d,await E_(u))},{parts:s,times:r}=this.header,o=s.reduce((c,d)=>c+d.frames,0),a=await i(r,o);this.times=Float64Array.from(a.whole,c=>r.low[0]+r.step[0]*c);let l=0;for(let c of s){let d={};for(let f of c.streams)d[f.name]=await i(f,c.frames);let{layout:u,good:h}=c;this.parts.push({layout:u,first:l,frames:c.frames,good:h,numbers:d}),l+=c.frames}}hello(){let{ropewalk:t,title:e}=this.header;return{type:"hello",protocol:1,ropewalk:t,client:0,mode:"replay",can:AT,limits:{},title:e,folder:null,address:"",speeds:[.01,4],grabs:0,exports:[]}}send(t){let e=this.header.duration;switch(t.type){case"play":this.time>=e&&this.moveTo(0),this.playing=!0,this.last=performance.now();break;case"pause":this.playing=!1;break;case"step":this.playing=!1,this.time=this.times[Math.min(this.index+(t.count??1),this.times.length-1)];break;case"speed":this.speed=t.value;break;case"seek":this.moveTo(Math.min(Math.max(0,t.time),e));break;case"reset":this.moveTo(0);break}if(this.show(),this.tellStatus(),t.id===void 0)return;let{id:i,type:s}=t;queueMicrotask(()=>this.events?.message({type:"done",id:i,command:s,step:this.index,frame:this.number}))}used(){}moveTo(t){this.time=t,this.leapt=!0,Math.abs(this.index-this.shown)>2&&this.jumped(this.index)}get index(){let[t,e]=[0,this.times.length];for(;e-t>1;){let i=t+e>>1;this.times[i]<=this.time+1e-6?t=i:e=i}return t}tick(t){let e=Math.min(.25,Math.max(0,(t-this.last)/1e3));this.last=t,this.playing&&(this.time=this.later(e*this.speed),this.playing=this.time<this.header.duration,(!this.playing||t-this.lastStatus>wT)&&this.tellStatus()),this.show()}later(t){let{duration:e,single:i}=this.header,{time:s}=this,r=this.times[this.times.length-1-i];if(!i||s+t<r)return Math.min(s+t,e);if(s<r)return r;let o=Math.min(1,(e-r)/(i*TT));return Math.min(s+t*o,e)}show(){let{index:t}=this;if(t===this.shown||!this.events)return;let e=this.shown;this.shown=t;let i=this.partOf(t);i!==this.layout&&this.tellLayout(i),this.number++;let s=e<t&&!this.leapt;this.leapt=!1,this.events.frame(this.frame(t,s?e:t-1))}partOf(t){return this.parts.findIndex(({first:e,frames:i})=>t<e+i)}tellLayout(t){this.layout=t,this.events?.message(this.parts[t].layout)}tellStatus(){this.lastStatus=performance.now();let{method:t,dt:e,duration:i}=this.header;this.events?.message({type:"status",playing:this.playing,speed:this.speed,realtime:this.playing?this.speed:0,slow:!1,text:"",time:this.time,step:this.index,dt:e,steps_per_frame:1,method:t,broken:!1,clients:1,address:"",duration:i})}frame(t,e=t-1){let{layout:i,first:s,good:r,numbers:o}=this.parts[this.partOf(t)],a=t-s,[l]=i.variants,{offsets:c,nodes:d,anchors:u}=l,h=new ArrayBuffer(i.bytes),f=new DataView(h,0,bT),g=(this.playing?1:0)|(t===this.times.length-1?16:0)|(a>=r?2:0);[1179670354,i.layout,this.number,g].forEach((X,O)=>f.setUint32(4*O,X,!0)),f.setFloat64(16,this.times[t],!0),f.setFloat64(24,t,!0),f.setFloat32(32,this.playing?this.speed:0,!0),f.setFloat32(36,this.speed,!0);let _=(X,O)=>new Float32Array(h,X,O),m=Mr(o.scalars,a,_(c.scalars,i.scalars.length)),p=Mr(o.positions,a,_(c.positions,3*d)),y=(X,O)=>{let lt=i.scalars.indexOf(X);lt>=0&&(m[lt]=O)},A=Math.max(e-s+1,a-ET,0),M=RT(o,Math.min(A,a),a),R=X=>new Uint16Array(h,X,d),T=Object.fromEntries(i.scalars.map((X,O)=>[X,O]));for(let X=A;X<a;X++){let O=Mr(o.scalars,X,new Float64Array(i.scalars.length));m[T.tension_max]=Math.max(m[T.tension_max],O[T.tension_max]),m[T.high]=Math.max(m[T.high],O[T.high]),m[T.low]=Math.min(m[T.low],O[T.low])}let v=[M.leastTension,M.greatestTension,M.tension],[E,k]=A_(v);Ao(M.tension,E,k,R(c.tension)),Ao(M.leastTension,E,k,R(c.least_tension)),Ao(M.greatestTension,E,k,R(c.greatest_tension)),y("tension_low",E),y("tension_high",k);let D=A_([M.greatestSpeed,M.speed])[1];Ao(M.speed,0,D,R(c.speed)),Ao(M.greatestSpeed,0,D,R(c.greatest_speed)),y("speed_high",D);let L=Float64Array.from({length:d},(X,O)=>i.up.reduce((lt,Z,Q)=>lt+Z*p[3*O+Q],0));for(let X of[c.least_height,c.greatest_height])Ao(L,m[T.low],m[T.high],R(X));_(c.greatest_force,u.length).set(M.greatestForce);let G=Mr(o.velocity,a,new Float32Array(3*u.length)),W=Mr(o.force,a,new Float32Array(3*u.length)),N=_(c.anchors,10*u.length);u.forEach(({index:X},O)=>{N.set(p.subarray(3*X,3*X+3),10*O),N.set(G.subarray(3*O,3*O+3),10*O+3),N.set(W.subarray(3*O,3*O+3),10*O+6),N[10*O+9]=1});let V=_(c.grabs,Math.floor((i.bytes-c.grabs)/4));for(let X=0;X<V.length;X+=8)V[X]=-1;return h}};function RT(n,t,e){let i=(a,l)=>Mr(n[a],l,new Float64Array(n[a].columns)),s=(a,l,c)=>{let d=new Float64Array(n[a].columns).fill(-c*(1/0));for(let u=t;u<=e;u++){let[h,f]=[i(a,u),i(l,u)];h.forEach((g,_)=>{let m=g+c*f[_];c*m>c*d[_]&&(d[_]=m)})}return d},r=n.greatest_force.columns,o=new Float64Array(r);for(let a=t;a<=e;a++){let[l,c]=[i("force",a),i("greatest_force",a)];o.forEach((d,u)=>{let h=Math.hypot(...l.subarray(3*u,3*u+3))+c[u];o[u]=Math.max(d,h)})}return{tension:i("tension",e),speed:i("speed",e),leastTension:s("tension","least_tension",-1),greatestTension:s("tension","greatest_tension",1),greatestSpeed:s("speed","greatest_speed",1),greatestForce:o}}function A_(n){let[t,e]=[0,1e-30];for(let i of n)for(let s of i)s<t&&(t=s),s>e&&(e=s);return[t,e]}function Ao(n,t,e,i){let s=65535/Math.max(e-t,1e-30);for(let r=0;r<n.length;r++)i[r]=Math.min(65535,Math.max(0,(n[r]-t)*s+.5))}var Ef=[500,1e3,2e3],CT=1e3,PT=4503,Kh=class{constructor(){this.base="./",this.socket=null,this.tries=0,this.ending="",this.events=null}open(t){this.events=t,this.connect()}connect(){let t=this.events,e=new URL("socket",location.href.split(/[?#]/)[0]);e.protocol=e.protocol.replace("http","ws");let i=new WebSocket(e,"ropewalk.1");i.binaryType="arraybuffer",this.socket=i,setTimeout(()=>{i.readyState===WebSocket.CONNECTING&&t.state("waiting","Setting up the simulation; its first run takes a minute or two …")},CT),i.onopen=()=>t.state("open",""),i.onmessage=({data:s})=>{if(typeof s!="string"){t.frame(s);return}let r=JSON.parse(s);r.type==="hello"&&([this.tries,this.ending]=[0,""]),r.type==="bye"&&(this.ending=r.text),t.message(r)},i.onclose=({code:s,reason:r})=>{if(this.socket!==i)return;let o=this.ending?Ef[2]:Ef[Math.min(this.tries++,Ef.length-1)];(s===1e3||s===1001)&&(this.ending||="The server has ended."),s===PT?t.state("full",r||"As many pages as allowed are open."):this.ending?t.state("ended",this.ending):s===4400||s===4429||s===1009?t.state("lost",`The server closed the connection: ${r||s}.`):t.state("lost","The connection to the server is lost; the run goes on there."),setTimeout(()=>this.connect(),o)}}send(t){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}used(t){this.send({type:"ack",frame:t})}};Vl(ig());var Tf=R_(),C_=new Zh(Tf??new Kh),IT=document.getElementById("app"),Af=new $l(IT,C_,b_);Tf?cg(Af,Tf):hg(Af);Object.assign(window,{ropewalk:ag(Af)});C_.open();})();
